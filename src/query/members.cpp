// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Order and readiness of members.
#include "query/members.h"

namespace epode {
namespace {

int depth_of(const Geom& geom)
{
    int depth = 0;
    for (const Geom* g = geom.space; g; g = g->space) ++depth;
    return depth;
}

}  // namespace

bool is_newer(const Geom& a, const Geom& b)
{
    const Geom *x = &a, *y = &b;
    if (x->space != y->space) {
        int dx = depth_of(a), dy = depth_of(b);
        for (; dx > dy; --dx) x = x->space;
        for (; dy > dx; --dy) y = y->space;
        for (; x->space != y->space; y = y->space) x = x->space;
    }
    return x->slot > y->slot;
}

bool make_ready(Space& space)
{
    clean(space);
    bool ready = space.broadphase.prepare();
    for (Geom* m : space.members) {
        if (!m) continue;
        if (is_space(*m))
            ready = make_ready(static_cast<Space&>(*m)) && ready;
        else
            refresh_pose(*m);
    }
    return ready;
}

void lock_around(const Geom& member, Space& outer, int count)
{
    for (Space* s = member.space; s; s = s == &outer ? nullptr : s->space) s->locks += count;
}

}  // namespace epode
