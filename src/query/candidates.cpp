// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Order and readiness of members.
#include "query/candidates.h"

#include <algorithm>

#include "collide/collide.h"

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

bool make_ready(Space& space, int rays)
{
    clean(space);
    bool ready = space.broadphase.prepare(rays);
    for (Geom* m : space.geoms) {
        if (!m) continue;
        if (is_space(*m))
            ready = make_ready(static_cast<Space&>(*m), rays) && ready;
        else
            refresh_pose(*m);
    }
    return ready;
}

bool collect_seen(Space& space, const QueryFilter& filter, Array<Geom*>& out)
{
    for (int slot = space.geoms.size(); slot-- > 0;) {
        Geom* m = space.geoms[slot];
        if (!m || !m->enabled || !space.broadphase.present(slot) || !filter.admits(*m)) continue;
        if (is_space(*m) ? !collect_seen(static_cast<Space&>(*m), filter, out) : !out.push(m)) return false;
    }
    return true;
}

bool collect_near(Space& space, const QueryFilter& filter, const Aabb& box, Array<Geom*>& out)
{
    Array<int> slots;
    slots.swap(space.scratch);
    slots.clear();
    bool complete = true;
    complete =
        space.broadphase.query(box, [&](int slot) { complete = slots.push(slot) && complete; }) && complete;
    std::sort(slots.begin(), slots.end(), [](int a, int b) { return a > b; });
    for (int i = 0; i < slots.size() && complete; ++i) {
        Geom* m = space.geoms[slots[i]];
        if (!m->enabled || !filter.admits(*m)) continue;
        complete = is_space(*m) ? collect_near(static_cast<Space&>(*m), filter, box, out) : out.push(m);
    }
    slots.swap(space.scratch);
    return complete;
}

void clean_while_held(Space& space, Geom& geom)
{
    const GeomHold hold(geom, space.helped > 0);
    clean(space);
}

bool may_call_program(std::span<Geom* const> geoms, const QueryFilter& filter)
{
    return filter.callback || any_overridden() ||
           std::any_of(geoms.begin(), geoms.end(), [](Geom* geom) { return geom_calls_program(*geom); });
}

void CandidateLock::add(Space& outer, std::span<Geom* const> candidates, int count)
{
    for (const Geom* m : candidates)
        for (Space* s = m->space; s; s = s == &outer ? nullptr : s->space) s->locks += count;
}

void CandidateLock::unlock(void* outer, const void* candidates, std::size_t size)
{
    add(*static_cast<Space*>(outer), {static_cast<Geom* const*>(candidates), size}, -1);
}

}  // namespace epode
