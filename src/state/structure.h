// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a state does not contain, and a world must have to accept it: the bodies, joints and geoms in order of
// creation, with mass and geoms of each body, type and bodies of each joint, and class, shape, offset and
// body of each geom. One hash covers all, and one byte marks each object, so that an error can name the first
// one that differs. Geoms are those of the space of the world-managed contacts, and those of the bodies.
// Bodies and geoms are measured again only when some structure has changed (base/objects/structure_edition.h); joints,
// among them the contact joints of the last step, every time.
#pragma once

#include "contacts/space_geoms.h"
#include "dynamics/body_table.h"

namespace epode {

class Structure {
  public:
    // False: out of memory. `bodies` and `geoms` have been gathered.
    [[nodiscard]] bool measure(const World& world, const BodyTable& bodies, const SpaceGeoms& geoms);
    // After measure(), as often as joints may have changed; the newest first.
    [[nodiscard]] bool measure_joints(std::span<Joint* const> joints, const BodyTable& bodies);

    int bodies() const { return bodies_; }
    int joints() const { return joints_; }
    int geoms() const { return geoms_; }
    std::uint64_t hash() const { return hash_; }
    // One byte for each body, then each geom, then each joint.
    std::span<const std::uint8_t> marks() const { return marks_.span(); }

    // Describes the first of as many marks that differs.
    const char* difference(const std::uint8_t* marks, char* text, std::size_t size) const;

  private:
    void add(std::uint64_t own);

    int bodies_ = 0, joints_ = 0, geoms_ = 0;
    std::uint64_t hash_ = 0, lasting_hash_ = 0;  // of all; of bodies and geoms
    Array<std::uint8_t> marks_;
};

}  // namespace epode
