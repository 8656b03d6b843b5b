// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Capsule: the points within `radius` of the segment |z| <= half_length on the local z axis.
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"

#include <algorithm>

namespace epode {
namespace {

const Capsule& shape(const Geom& geom) { return static_cast<const ShapeGeom<Capsule>&>(geom).shape; }

Aabb aabb(Geom& geom)
{
    const Capsule& s = shape(geom);
    const Vec3 c = load(geom.position), axis = load_mat(geom.rotation).column(2);
    const Vec3 e = s.half_length * abs(axis) + Vec3{s.radius, s.radius, s.radius};
    return {c - e, c + e};
}

bool zero_sized(const Geom& geom) { return shape(geom).radius == 0; }

bool legal(Real radius, Real length)
{
    return usable(radius) && usable(length) && radius >= 0 && length >= 0;
}

CoreSize core_size(const Geom& geom) { return {shape(geom).half_length, shape(geom).radius}; }
Real core_reach(const Geom& geom, Vec3 d) { return shape(geom).half_length * std::fabs(d.z); }
Real half_thickness(const Geom& geom) { return shape(geom).radius; }

void describe_capsule(const Geom& geom, DifWriter& out)
{
    out.text("type", "capsule");
    out.real("radius", shape(geom).radius);
    out.real("length", 2 * shape(geom).half_length);
}

RevolvedSolid round_solid(const Geom& geom)
{
    const Capsule& c = shape(geom);
    RevolvedSolid out;
    out.add_ball(-c.half_length - c.radius, -c.half_length, -c.half_length, c.radius);
    out.add_cylinder(-c.half_length, c.half_length, c.radius);
    out.add_ball(c.half_length, c.half_length + c.radius, c.half_length, c.radius);
    return out;
}

constexpr SolidType kSolid = {.view = view_of_shape<Capsule>,
                              .core_reach = core_reach,
                              .core_size = core_size,
                              .round_solid = round_solid};

}  // namespace

const GeomType kCapsuleType = {.number = dCapsuleClass,
                               .aabb = aabb,
                               .zero_sized = zero_sized,
                               .destroy = destroy_pooled<ShapeGeom<Capsule>>,
                               .describe = describe_capsule,
                               .solid = &kSolid,
                               .half_thickness = half_thickness,
                               .create = create_pooled<ShapeGeom<Capsule>>,
                               .structure = structure_of_sizes<Capsule>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateCapsule(dSpaceID space, dReal radius, dReal length)
{
    EPODE_USER(legal(radius, length), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Capsule{radius, length / 2});
}

extern "C" void dGeomCapsuleSetParams(dGeomID capsule, dReal radius, dReal length)
{
    EPODE_GEOM_AS(Capsule, geom, capsule);
    EPODE_USER(legal(radius, length));
    EPODE_UNLOCKED(geom);
    geom->shape = {radius, length / 2};
    mark_changed(*geom);
}

extern "C" void dGeomCapsuleGetParams(dGeomID capsule, dReal* radius, dReal* length)
{
    EPODE_GEOM_AS(Capsule, geom, capsule);
    EPODE_USER(radius && length);
    *radius = geom->shape.radius;
    *length = 2 * geom->shape.half_length;
}

extern "C" dReal dGeomCapsulePointDepth(dGeomID capsule, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Capsule, geom, capsule, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    Vec3 q = pose_of(*geom).to_local({x, y, z});
    q.z -= std::clamp(q.z, -geom->shape.half_length, geom->shape.half_length);
    return geom->shape.radius - length(q);
}
