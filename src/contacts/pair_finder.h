// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs of a space may touch, in the space's order, and which record of the last step belongs to each.
// Mostly the pairs are those of the last step, one after the other: the record behind the one found last is
// looked at first, and a table by serial numbers, made when it is needed, only where that fails.
#pragma once

#include "base/array.h"
#include "collide/space.h"
#include "contacts/active_geoms.h"
#include "contacts/ahead/speculative_motion.h"
#include "contacts/contact_pair.h"

namespace epode {

struct GeomPair {
    Geom *a, *b;   // null: the pairs of this range end here
    int old = -1;  // the record of the last step, -1: none
};
inline constexpr int kPairRange = 512;

// Boxes of what has moved, unless the space is locked, and room in the broad phase for the whole way of what
// moves. `soon`: where bodies will be when pairs are looked for again.
void expect_motion(Space& space, const SpeculativeMotion& soon, const Tasks& tasks);

// Then all pairs of geoms that are no spaces, spaces in it opened. Ranges of kPairRange pairs may end early.
// False: out of memory.
[[nodiscard]] bool find_geom_pairs(Space& space, const SpeculativeMotion& soon, const Tasks& tasks,
                                   Array<GeomPair>& out);

// Both for the active members of a space that holds none but geoms that stand alone: as if all had been
// looked at, and only their pairs been kept. `near` is scratch.
void expect_motion(Space& space, const SpeculativeMotion& soon, const ActiveGeoms& active);
[[nodiscard]] bool find_geom_pairs(Space& space, const ActiveGeoms& active, Array<SlotPair>& near,
                                   Array<GeomPair>& out);

class RecordFinder {
  public:
    explicit RecordFinder(const Array<ContactPair>& records, Array<int>& table)
        : records_(records), table_(table)
    {}

    // Needed by finders that are copies of one, each for its worker. False: out of memory.
    [[nodiscard]] bool make_table();
    // The pair's record, -1: none, -2: out of memory.
    int find(std::uint64_t serial1, std::uint64_t serial2);

  private:
    bool is(int record, std::uint64_t serial1, std::uint64_t serial2) const;

    const Array<ContactPair>& records_;
    Array<int>& table_;  // open addressing, -1: free; empty: not made
    bool made_ = false;
    int next_ = 0;
};

}  // namespace epode
