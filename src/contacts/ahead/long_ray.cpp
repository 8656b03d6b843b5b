// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/ahead/long_ray.h"

#include "collide/collide.h"
#include "collide/types/registry.h"

namespace epode {
namespace {

constexpr Real kLongest = Real(1e3);  // m

// Pair functions read no more of a ray's geom than its shape.
struct LongRay : ShapeGeom<Ray> {
    LongRay() : ShapeGeom<Ray>(kRayType) { shape.length = kLongest, shape.closest_hit = true; }
};

RayHit cast(Vec3 from, Vec3 direction, Geom& solid, Geom& other, const Pose& pose)
{
    static const LongRay ray;
    const PairFunction pair = own_pair(dRayClass, other.type->number);
    if (!pair) return {};
    dContactGeom hit;
    ContactSink sink(&hit, int(sizeof hit), 1, false);
    sink.name(to_handle(&solid), to_handle(&other));
    const Vec3 d = direction;
    pair(ray, {from, {{0, 0, d.x}, {0, 0, d.y}, {0, 0, d.z}}}, other, pose, sink);
    return sink.count() > 0 ? RayHit{hit.depth, load(hit.normal)} : RayHit{};
}

}  // namespace

RayHit cast_long_ray(Vec3 from, Vec3 direction, Geom& solid, Geom& other, const Pose& pose)
{
    const TrimeshGeom* const mesh = as_trimesh(other);
    if (!mesh || !mesh->shape.has_callbacks()) return cast(from, direction, solid, other, pose);
    if (mesh->shape.ray_hits) return {};  // which asks about rays of the program
    const GeomHold hold(solid);
    const MeshHold held(other);
    return cast(from, direction, solid, other, pose);
}

}  // namespace epode
