// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shape casts against geoms and spaces: the API functions. In a space, the candidates are the geoms whose
// boxes the moving box reaches before the best hit so far. Every geom that may give an equal hit is tried,
// and the newer one wins.
#include <algorithm>

#include "base/float_environment.h"
#include "collide/collide.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "ode/ext.h"
#include "query/candidates.h"
#include "query/effort.h"
#include "query/ray_query.h"
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

struct CastHit {
    SweepHit at;
    Vec3 face_normal;
    int order;  // of the candidates
};

// The face that a ray along the way meets where the solid touched, aimed a little below the surface; round solids have none.
Vec3 face_normal(RayProbe& probe, const Geom& solid, const Way& way, const SweepHit& hit)
{
    constexpr Real kBelow = kSingle ? Real(1e-3) : Real(1e-5), kBefore = 100;  // of the size
    Geom& geom = *hit.named;
    if (geom.type->number == dPlaneClass || geom.type->number == dRayClass || hit.depth > 0)
        return hit.normal;
    if (geom.type->solid && geom.type->solid->round) return hit.normal;
    const Aabb& box = box_of(const_cast<Geom&>(solid));
    const Real below = kBelow * length(box.hi - box.lo), before = kBefore * below;
    if (!(below < kInf)) return hit.normal;
    const RayQuery ray{hit.pos - below * hit.normal - before * way.along, way.along, 2 * before, {}};
    probe.aim(ray, ray.length);
    dContactGeom contact;
    ContactArray one{&contact, int(sizeof contact), 1, false};
    collide(probe, geom, one);
    const Vec3 n = one.count > 0 ? load(contact.normal) : hit.normal;
    return dot(n, way.along) < 0 ? n : hit.normal;
}

// Nearest first; of equal ones the geom that has joined last.
bool all(Geom& solid, const Way& way, const Array<Geom*>& others, const QueryFilter& filter,
         Array<CastHit>& out, bool& cut_short)
{
    const Aabb box = box_of(solid);
    RayProbe probe;
    bool complete = true;
    for (int i = 0; i < others.size(); ++i) {
        Geom& m = *others[i];
        if (&m == &solid || of_one_body(solid, m)) continue;
        if (m.type->number != dHeightfieldClass && !boxes_may_meet(box, way, box_of(m), way.length)) continue;
        const SweepHit hit = sweep(solid, way, m, way.length);
        cut_short = cut_short || hit.cut_short;
        if (!(hit.distance < kInf) || !filter.keeps(to_handle(hit.named))) continue;
        complete = out.push({hit, face_normal(probe, solid, way, hit), i}) && complete;
    }
    std::sort(out.begin(), out.end(), [](const CastHit& a, const CastHit& b) {
        return a.at.distance != b.at.distance ? a.at.distance < b.at.distance : a.order < b.order;
    });
    return complete;
}

void put(const CastHit& hit, dCastHit& out)
{
    out = dCastHit{};
    out.geom = to_handle(hit.at.named);
    store(out.pos, hit.at.pos), store(out.normal, hit.at.normal), store(out.face_normal, hit.face_normal);
    out.distance = hit.at.distance, out.depth = hit.at.depth, out.side = hit.at.side;
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
    way.skips_overlaps = filter.skips_overlaps;
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

extern "C" int dSpaceCastAll(dSpaceID id, dGeomID o, const dVector3 motion, const dQueryFilter* given,
                             dCastHit* hits, int capacity)
{
    const FloatEnvironment floats;
    EPODE_SPACE(space, id, 0);
    EPODE_GEOM(solid, o, 0);
    EPODE_USER(motion && usable(motion, 3), 0);
    EPODE_USER(capacity >= 0 && (hits || capacity == 0), 0);
    EPODE_USER_SAY(is_solid(*solid), "argument not convex", 0);
    Way way;
    EPODE_USER(way_of(motion, way), 0);
    QueryFilter filter{solid->category, solid->collide};
    if (!read_filter(given, __func__, filter)) return 0;
    way.skips_overlaps = filter.skips_overlaps;
    clean_while_held(*space, *solid);
    Array<Geom*> near;
    EPODE_USER_SAY(collect_near(*space, filter, swept(box_of(*solid), way), near), kOutOfMemory, 0);
    const bool called = may_call_program(near.span(), filter);
    const GeomHold hold(*solid, called);
    const CandidateLock lock(called ? space : nullptr, near);
    Array<CastHit> found;
    bool cut_short = false;
    EPODE_USER_SAY(all(*solid, way, near, filter, found, cut_short), kOutOfMemory, 0);
    for (int i = 0; i < std::min(capacity, found.size()); ++i) put(found[i], hits[i]);
    if (cut_short) report_cut_short(__func__);
    return found.size();
}
