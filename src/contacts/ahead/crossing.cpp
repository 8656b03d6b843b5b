// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/ahead/crossing.h"

#include <algorithm>
#include <cmath>

#include "collide/solid_type.h"
#include "contacts/ahead/long_ray.h"

namespace epode {
namespace {

constexpr Real kMaxParts = 16;
constexpr Real kLeast = Real(1) / 64;  // of the step

bool is_mesh(const Geom& geom) { return geom.type->number == dTriMeshClass; }

Real half_of(const Box& box) { return std::min({box.half.x, box.half.y, box.half.z}); }

// Walls are boxes, and GeomType::half_thickness has a lower bound.
Real half_thickness(const Geom& geom)
{
    if (geom.type->number == dBoxClass) return half_of(static_cast<const ShapeGeom<Box>&>(geom).shape);
    return is_solid(geom) ? geom.type->half_thickness(geom) : Real(0);
}

// In the frame of what is at `pose`.
Vec3 middle_of(Geom& geom, const Pose& pose)
{
    const Aabb& box = box_of(geom);
    return transposed_times(pose.R, Real(0.5) * (box.lo + box.hi) - pose.p);
}

Real share_before(const PlacedGeom& solid, const Pose& soon, const PlacedGeom& mesh, const Pose& mesh_soon)
{
    const Vec3 middle = middle_of(solid.geom, solid.pose), from = solid.pose.to_world(middle);
    const Vec3 to = mesh.pose.to_world(transposed_times(mesh_soon.R, soon.to_world(middle) - mesh_soon.p));
    Vec3 direction = to - from;
    const Real way = length(direction);
    if (!normalize(direction)) return 1;
    const RayHit hit = cast_long_ray(from, direction, solid.geom, mesh.geom, mesh.pose);
    if (!(hit.distance < way)) return 1;
    const Real before = half_thickness(solid.geom) / (2 * std::fabs(dot(hit.normal, direction)));
    const Real share = (hit.distance - before) / way;
    return share > kLeast ? share : kLeast;  // not a number, where what has no thickness slides along
}

}  // namespace

Real thickness(const Geom& first, const Geom& second)
{
    if (is_solid(first) && is_solid(second)) return std::min(half_thickness(first), half_thickness(second));
    return half_thickness(is_solid(first) ? first : second);
}

bool may_pass(const Geom& first, const Geom& second, Real way)
{
    if (is_solid(first) && is_solid(second)) return parts_of_way(first, second, way) > 1;
    return (is_mesh(first) || is_mesh(second)) && way > (half_thickness(first) + half_thickness(second)) / 2;
}

int parts_of_way(const Geom& first, const Geom& second, Real way)
{
    return int(std::min(std::ceil(way / (half_thickness(first) + half_thickness(second))), kMaxParts));
}

Real share_before_crossing(const PairWay& pair)
{
    if (is_solid(pair.first.geom) && is_mesh(pair.second.geom))
        return share_before(pair.first, pair.first_soon, pair.second, pair.second_soon);
    if (is_solid(pair.second.geom) && is_mesh(pair.first.geom))
        return share_before(pair.second, pair.second_soon, pair.first, pair.first_soon);
    return 1;
}

}  // namespace epode
