// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What queries of spaces have in common: which members they look at, and in which order they report them.
// Members of nested spaces count as members, at the place of the space that holds them; order is that of
// dSpaceCollide, newer before older, and so depends on the order of joining alone, never on the shape of a
// tree. Bits and enabling of a nested space hold for what is in it.
#pragma once

#include "collide/space.h"
#include "query/query_filter.h"

namespace epode {

// Did a join later? Both are members, at any depth, of one space.
bool is_newer(const Geom& a, const Geom& b);

// Brings the boxes and the tree of a space and of all in it up to date, and the poses of all members, so that
// several threads may cast so many rays. False: memory is exhausted; it may be asked, but not by the tree.
bool make_ready(Space& space, int rays);

// visit(geom) for every member at any depth that is no space, until it answers false.
template <typename Visit>
bool each_candidate(Space& space, Visit&& visit)
{
    for (int slot = space.members.size(); slot-- > 0;) {
        Geom* m = space.members[slot];
        if (!m) continue;
        if (is_space(*m) ? !each_candidate(static_cast<Space&>(*m), visit) : !visit(*m)) return false;
    }
    return true;
}

// All that the filter admits in a space, or of that what may meet a box: no spaces, newest first. The
// caller has cleaned the space, and with it what is in it: here no function of the program is called. False:
// memory is exhausted.
[[nodiscard]] bool collect_seen(Space& space, const QueryFilter& filter, Array<Geom*>& out);
[[nodiscard]] bool collect_near(Space& space, const QueryFilter& filter, const Aabb& box, Array<Geom*>& out);

// Locks the spaces from those of members up to an outer one, so that the members stay what and where they are
// while functions of the program may be called. Null: nothing is to be locked.
class CandidateLock {
  public:
    CandidateLock(Space* outer, const Array<Geom*>& candidates) : outer_(outer), candidates_(candidates)
    {
        add(1);
    }
    CandidateLock(const CandidateLock&) = delete;
    CandidateLock& operator=(const CandidateLock&) = delete;
    ~CandidateLock() { add(-1); }

  private:
    void add(int count) const;
    Space* outer_;
    const Array<Geom*>& candidates_;
};

}  // namespace epode
