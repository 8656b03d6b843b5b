// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The geoms of a space by number, spaces in it opened, each before its members: in the order in which they
// have joined, which is the same in every world that was built by the same calls. Numbers are found by serial
// number, without a look at the geom: in a table of all serials from the first to the last, or, where most of
// these belong to others, by bisection.
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
    // The number of the geom with this serial, or -1.
    int find(std::uint64_t serial) const
    {
        if (table_.empty()) return search(serial);
        const std::uint64_t i = serial - first_;
        return i < std::uint64_t(table_.size()) ? table_.data()[i] : -1;
    }
    int find(const Geom& geom) const { return find(geom.serial); }

  private:
    struct Entry {
        std::uint64_t serial;
        int number;
    };
    [[nodiscard]] bool add(Space& space);
    [[nodiscard]] bool make_table();
    int search(std::uint64_t serial) const;

    Array<Geom*> geoms_;
    Array<Entry> entries_;  // by serial
    Array<int> table_;      // of serials from first_ on; empty: there would be too many
    std::uint64_t first_ = 0;
};

}  // namespace epode
