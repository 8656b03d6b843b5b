// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a state does not say and a world must have before it can take one: how many bodies, joints and geoms
// there are, in order of creation, the masses of the bodies and what hangs on them, type and bodies of each
// joint, class, shape, place on its body and body of each geom. One hash for all, and one byte for each
// object, so that the first that is another one can be named. Geoms are those of the space whose contacts the
// world manages, and those of its bodies.
#pragma once

#include "contacts/space_geoms.h"
#include "dynamics/body_table.h"

namespace epode {

class Structure {
  public:
    // False: out of memory. `bodies` and `geoms` have been gathered.
    [[nodiscard]] bool measure(const World& world, const BodyTable& bodies, const SpaceGeoms& geoms);

    int bodies() const { return bodies_; }
    int joints() const { return joints_; }
    int geoms() const { return marks_.size() - bodies_ - joints_; }
    std::uint64_t hash() const { return hash_; }
    // One byte each: of the bodies, the joints, the geoms.
    std::span<const std::uint8_t> marks() const { return marks_.span(); }

    // The words for the first of as many marks that is another one.
    const char* difference(const std::uint8_t* marks, char* text, std::size_t size) const;

  private:
    void add(std::uint64_t own);

    int bodies_ = 0, joints_ = 0;
    std::uint64_t hash_ = 0;
    Array<std::uint8_t> marks_;
};

}  // namespace epode
