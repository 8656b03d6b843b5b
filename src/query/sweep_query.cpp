// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shape casts against geoms and spaces: the API functions. In a space, the candidates are the geoms whose
// boxes the moving box reaches before the best hit so far. Every geom that may give an equal hit is tried,
// and the newer one wins.
#include "base/float_environment.h"
#include "collide/collide.h"
#include "collide/types/registry.h"
#include "ode/ext.h"
#include "query/candidates.h"
#include "query/effort.h"
#include "query/sweep.h"
#include "query/triangle_set.h"

namespace epode {
namespace {

Aabb swept(const Aabb& box, const Way& way)
{
    const Vec3 last = way.length * way.along;
    return {min(box.lo, box.lo + last), max(box.hi, box.hi + last)};
}

// True if the moving box may reach the other one within `limit`.
bool boxes_may_meet(const Aabb& box, const Way& way, const Aabb& other, Real limit)
{
    if (!bounded(box) || !bounded(other)) return true;
    const Vec3 half = Real(0.5) * (box.hi - box.lo), centre = box.lo + half;
    const Aabb wide = {other.lo - half, other.hi + half};
    return TreeRay(centre, way.along, wide).enters(wide, limit) < kInf;
}

SweepHit nearest(Geom& solid, const Way& way, const Array<Geom*>& others, const QueryFilter& filter)
{
    SweepHit best;
    const Aabb box = box_of(solid);
    for (Geom* m : others) {
        const Real limit = best.distance < way.length ? best.distance : way.length;
        if (m == &solid || of_one_body(solid, *m)) continue;
        // Below the box of a height field is ground.
        if (m->type->number != dHeightfieldClass && !boxes_may_meet(box, way, box_of(*m), limit)) continue;
        const SweepHit hit = sweep(solid, way, *m, limit);
        const bool cut_short = best.cut_short || hit.cut_short;
        if (hit.distance < best.distance && filter.keeps(to_handle(hit.named))) best = hit;
        best.cut_short = cut_short;
    }
    return best;
}

void put(const SweepHit& hit, dQueryHit& out)
{
    out = dQueryHit{};
    out.side = -1;
    if (!(hit.distance < kInf)) return;
    out.geom = to_handle(hit.named);
    store(out.pos, hit.pos);
    store(out.normal, hit.normal);
    out.distance = hit.distance;
    out.side = hit.side;
}

// False for no motion at all; its square must not overflow either.
bool way_of(const dReal* motion, Way& way)
{
    way.along = load(motion);
    way.length = length(way.along);
    return way.length < kMaxMagnitude && normalize(way.along);
}

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dGeomCast(dGeomID o, const dVector3 motion, dGeomID other_id, dQueryHit* hit)
{
    const FloatEnvironment floats;
    EPODE_GEOM(solid, o, 0);
    EPODE_GEOM(other, other_id, 0);
    EPODE_USER(solid != other && motion && hit && usable(motion, 3), 0);
    EPODE_USER_SAY(is_solid(*solid), "argument not convex", 0);
    EPODE_USER_SAY(!is_space(*other), "argument must not be a space", 0);
    Way way;
    EPODE_USER(way_of(motion, way), 0);
    const bool called = geom_calls_program(*other);
    const GeomHold hold(*solid, called), hold_other(*other, called);
    const SweepHit found = sweep(*solid, way, *other, way.length);
    put(found, *hit);
    if (found.cut_short) report_cut_short(__func__);
    return found.distance < kInf;
}

extern "C" int dSpaceCast(dSpaceID id, dGeomID o, const dVector3 motion, const dQueryFilter* given,
                          dQueryHit* hit)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_GEOM(solid, o, 0);
    EPODE_USER(motion && hit && usable(motion, 3), 0);
    EPODE_USER_SAY(is_solid(*solid), "argument not convex", 0);
    Way way;
    EPODE_USER(way_of(motion, way), 0);
    QueryFilter filter{solid->category, solid->collide};
    if (!read_filter(given, __func__, filter)) return 0;
    clean_while_held(*space, *solid);
    Array<Geom*> near;
    EPODE_USER_SAY(collect_near(*space, filter, swept(box_of(*solid), way), near), kOutOfMemory, 0);
    const bool called = may_call_program(near.span(), filter);
    const GeomHold hold(*solid, called);
    const CandidateLock lock(called ? space : nullptr, near);
    const SweepHit found = nearest(*solid, way, near, filter);
    put(found, *hit);
    if (found.cut_short) report_cut_short(__func__);
    return found.distance < kInf;
}
