// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Overlap and distance of geoms: the API functions. The leaves of spaces are taken in order of insertion;
// pairs whose boxes are farther apart than the best distance so far are skipped.
#include <algorithm>

#include "base/float_environment.h"
#include "collide/collide.h"
#include "collide/types/registry.h"
#include "ode/ext.h"
#include "query/candidates.h"
#include "query/distance.h"
#include "query/effort.h"
#include "query/triangle_set.h"

namespace epode {
namespace {

Space* space_of(Geom& geom) { return is_space(geom) ? static_cast<Space*>(&geom) : nullptr; }

bool leaves_of(Geom& geom, const QueryFilter& filter, Array<Geom*>& out)
{
    return is_space(geom) ? collect_seen(static_cast<Space&>(geom), filter, out) : out.push(&geom);
}

bool agree(const Geom& a, const Geom& b) { return QueryFilter{a.category, a.collide}.admits(b); }

// A lower bound of the distance. 0 for infinite boxes and for height fields, which are solid without end
// below.
Real box_gap(Geom& a, Geom& b)
{
    if (a.type->number == dHeightfieldClass || b.type->number == dHeightfieldClass) return 0;
    const Aabb &x = box_of(a), &y = box_of(b);
    return bounded(x) && bounded(y) ? gap_between(x, y) : 0;
}

// The least separation of two lists of leaves. `by_bits`: test bits, because one of the two is a space.
GeomSeparation least(const Array<Geom*>& first, const Array<Geom*>& second, bool by_bits, Real limit)
{
    GeomSeparation best;
    for (Geom* a : first)
        for (Geom* b : second) {
            if (a == b || (by_bits && !agree(*a, *b))) continue;
            const Real max_distance = best.a ? best.distance : limit;
            if (box_gap(*a, *b) > std::max(max_distance, Real(0))) continue;
            const GeomSeparation s = separation(*a, *b, max_distance);
            const bool cut_short = best.cut_short || s.cut_short;
            if (s.a && (!best.a || s.distance < best.distance)) best = s;
            best.cut_short = cut_short;
        }
    return best;
}

// False: out of memory.
bool separation_of(Geom& a, Geom& b, Real max_distance, GeomSeparation& found)
{
    for (Geom* g : {&a, &b})
        if (is_space(*g)) clean(static_cast<Space&>(*g));
    Array<Geom*> first, second;
    if (!leaves_of(a, {b.category, b.collide}, first) || !leaves_of(b, {a.category, a.collide}, second))
        return false;
    const CandidateLock lock_a(space_of(a), first), lock_b(space_of(b), second);
    found = least(first, second, is_space(a) || is_space(b), max_distance);
    return true;
}

// The same where functions of the program may be called.
bool separation_while_held(Geom& a, Geom& b, Real max_distance, GeomSeparation& found)
{
    const auto calls = [](Geom& geom) { return is_space(geom) || geom_calls_program(geom); };
    if (!calls(a) && !calls(b)) return separation_of(a, b, max_distance, found);
    const GeomHold hold_a(a), hold_b(b);
    return separation_of(a, b, max_distance, found);
}

void put(const GeomSeparation& s, dQueryDistance& out)
{
    out = dQueryDistance{};
    out.distance = s.distance;
    store(out.pos1, s.on_a);
    store(out.pos2, s.on_b);
    store(out.normal, s.normal);
    out.g1 = to_handle(s.a);
    out.g2 = to_handle(s.b);
    out.side1 = s.side_a;
    out.side2 = s.side_b;
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dGeomGetDistance(dGeomID o1, dGeomID o2, dReal max_distance, dQueryDistance* result)
{
    const FloatEnvironment floats;
    EPODE_GEOM(a, o1, 0);
    EPODE_GEOM(b, o2, 0);
    EPODE_USER(a != b && result && (usable(max_distance) || max_distance == kInf), 0);
    GeomSeparation found;
    EPODE_USER_SAY(separation_while_held(*a, *b, max_distance, found), kOutOfMemory, 0);
    if (found.a) put(found, *result);
    if (found.cut_short) report_cut_short(__func__);
    return found.a != nullptr;
}

extern "C" int dSpaceOverlap(dSpaceID id, dGeomID o, const dQueryFilter* given, dGeomID* geoms, int capacity)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_GEOM(geom, o, 0);
    EPODE_USER(capacity >= 0 && (geoms || capacity == 0), 0);
    EPODE_USER_SAY(!is_space(*geom), "argument must not be a space", 0);
    QueryFilter filter{geom->category, geom->collide};
    if (!read_filter(given, __func__, filter)) return 0;
    Array<Geom*> near;
    clean_while_held(*space, *geom);
    EPODE_USER_SAY(collect_near(*space, filter, box_of(*geom), near), kOutOfMemory, 0);
    const bool called = may_call_program(near.span(), filter) || geom_calls_program(*geom);
    const GeomHold hold(*geom, called);
    const CandidateLock lock(called ? space : nullptr, near);
    int count = 0;
    bool cut_short = false;
    for (Geom* m : near) {
        if (!can_pair(*geom, *m) || !overlapping(*geom, *m, cut_short) || !filter.keeps(to_handle(m)))
            continue;
        if (count < capacity) geoms[count] = to_handle(m);
        ++count;
    }
    if (cut_short) report_cut_short(__func__);
    return count;
}
