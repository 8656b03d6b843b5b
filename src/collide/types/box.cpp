// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box: |x_i| <= half_i.
//   half extent of the bounding box along world axis i: sum_j |R_ij| half_j
//   depth of a point q (local): inside min_i (half_i - |q_i|), outside minus the distance to the box. (The
//   original measures outside points to the far face; its sign is the same.)
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"

#include <algorithm>

namespace epode {
namespace {

const Box& shape(const Geom& geom) { return static_cast<const ShapeGeom<Box>&>(geom).shape; }

Aabb aabb(Geom& geom)
{
    const Vec3 h = shape(geom).half, c = load(geom.position);
    const Mat3 R = load_mat(geom.rotation);
    const Vec3 e{dot(abs(R.row0), h), dot(abs(R.row1), h), dot(abs(R.row2), h)};
    return {c - e, c + e};
}

bool zero_sized(const Geom& geom)
{
    const Vec3 h = shape(geom).half;
    return h.x == 0 || h.y == 0 || h.z == 0;
}

bool legal(Real lx, Real ly, Real lz)
{
    return usable(lx) && usable(ly) && usable(lz) && lx >= 0 && ly >= 0 && lz >= 0;
}

CoreSize core_size(const Geom& geom) { return {length(shape(geom).half), 0}; }
Real core_reach(const Geom& geom, Vec3 d) { return dot(abs(d), shape(geom).half); }
Real half_thickness(const Geom& geom)
{
    const Vec3 h = shape(geom).half;
    return thickness_at_least(std::min(std::min(h.x, h.y), h.z), max_component(h));
}

void describe_box(const Geom& geom, DifWriter& out)
{
    const Vec3 h = shape(geom).half;
    out.text("type", "box");
    out.list("sides", {2 * h.x, 2 * h.y, 2 * h.z});
}

constexpr SolidType kSolid = {
    .view = view_of_shape<Box>, .core_reach = core_reach, .core_size = core_size, .round = false};

}  // namespace

const GeomType kBoxType = {.number = dBoxClass,
                           .aabb = aabb,
                           .zero_sized = zero_sized,
                           .destroy = destroy_pooled<ShapeGeom<Box>>,
                           .describe = describe_box,
                           .solid = &kSolid,
                           .half_thickness = half_thickness,
                           .create = create_pooled<ShapeGeom<Box>>,
                           .structure = structure_of_sizes<Box>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateBox(dSpaceID space, dReal lx, dReal ly, dReal lz)
{
    EPODE_USER(legal(lx, ly, lz), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Box{Real(0.5) * Vec3{lx, ly, lz}});
}

extern "C" void dGeomBoxSetLengths(dGeomID box, dReal lx, dReal ly, dReal lz)
{
    EPODE_GEOM_AS(Box, geom, box);
    EPODE_USER(legal(lx, ly, lz));
    EPODE_UNLOCKED(geom);
    geom->shape.half = Real(0.5) * Vec3{lx, ly, lz};
    mark_changed(*geom);
}

extern "C" void dGeomBoxGetLengths(dGeomID box, dVector3 result)
{
    EPODE_GEOM_AS(Box, geom, box);
    EPODE_USER(result);
    store(result, 2 * geom->shape.half);
}

extern "C" dReal dGeomBoxPointDepth(dGeomID box, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Box, geom, box, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    const Vec3 beyond = abs(pose_of(*geom).to_local({x, y, z})) - geom->shape.half;
    const Real nearest = max_component(beyond);
    return nearest <= 0 ? -nearest : -length(max(beyond, Vec3{}));
}
