// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all queries of spaces share: which geoms are candidates, and in which order they are reported. The
// geoms of nested spaces are candidates, at the position of the space that holds them. The order is that of
// dSpaceCollide, newer before older: it depends on the order of insertion only, never on the shape of a tree.
// Bits and the enabled flag of a nested space apply to all geoms in it.
#pragma once

#include "collide/space.h"
#include "query/query_filter.h"

namespace epode {

// True if `a` was inserted later. Both must be in one space, at any depth.
bool is_newer(const Geom& a, const Geom& b);

// Updates the boxes and trees of a space and of all nested spaces, and the poses of all geoms in them, so
// that several threads can cast this many rays. False: out of memory; rays still work, but without the tree.
bool make_ready(Space& space, int rays);

// Calls visit(geom) for every geom at any depth that is not a space, until visit returns false.
template <typename Visit>
bool each_candidate(Space& space, Visit&& visit)
{
    for (int slot = space.geoms.size(); slot-- > 0;) {
        Geom* m = space.geoms[slot];
        if (!m) continue;
        if (is_space(*m) ? !each_candidate(static_cast<Space&>(*m), visit) : !visit(*m)) return false;
    }
    return true;
}

// Collects the geoms that the filter admits, or those of them that may overlap a box: no spaces, newest
// first. The caller has cleaned the space, which includes nested spaces, so no callback runs here. False: out
// of memory.
[[nodiscard]] bool collect_seen(Space& space, const QueryFilter& filter, Array<Geom*>& out);
[[nodiscard]] bool collect_near(Space& space, const QueryFilter& filter, const Aabb& box, Array<Geom*>& out);

// Cleans a space, which may call functions of the program for what is in it; the geom outlives them.
void clean_while_held(Space& space, Geom& geom);
// Whether functions of the program may be called while these are asked.
bool may_call_program(std::span<Geom* const> geoms, const QueryFilter& filter);

// Locks every space from those of the candidates up to an outer one, so that callbacks of the program cannot
// change the candidates. Null: locks nothing, as where none can be called. The list keeps its memory meanwhile.
class CandidateLock {
  public:
    CandidateLock(Space* outer, const Array<Geom*>& candidates)
        : guard_(outer && !candidates.empty() ? unlock : nullptr, outer, candidates.data(),
                 std::size_t(candidates.size()))
    {
        if (outer) add(*outer, candidates.span(), 1);
    }

  private:
    static void add(Space& outer, std::span<Geom* const> candidates, int count);
    static void unlock(void* outer, const void* candidates, std::size_t size);
    CallGuard guard_;
};

}  // namespace epode
