// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The geoms of a space by number, spaces in it opened, each before its members: in the order in which they
// have joined, which is the same in every world that was built by the same calls.
#pragma once

#include "base/array.h"
#include "collide/space.h"

namespace epode {

class SpaceGeoms {
  public:
    // False: out of memory. null: none.
    [[nodiscard]] bool gather(Space* space);

    int count() const { return geoms_.size(); }
    Geom& operator[](int i) const { return *geoms_.data()[i]; }
    std::span<Geom* const> all() const { return geoms_.span(); }
    // The number of the geom, or -1.
    int find(const Geom& geom) const;

  private:
    struct Entry {
        std::uint64_t serial;
        int number;
    };
    [[nodiscard]] bool add(Space& space);

    Space* root_ = nullptr;
    Array<Geom*> geoms_;
    Array<int> by_slot_;   // of the members of the space itself
    Array<Entry> deeper_;  // of all others, by serial
};

}  // namespace epode
