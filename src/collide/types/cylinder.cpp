// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cylinder: x^2 + y^2 <= radius^2, |z| <= half_length.
//   half extent of the bounding box along world axis i, a = R z being the axis:
//   half_length |a_i| + radius sqrt(1 - a_i^2): the ends' centre and the most of a circle perpendicular to a.
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"

#include <algorithm>

namespace epode {
namespace {

const Cylinder& shape(const Geom& geom) { return static_cast<const ShapeGeom<Cylinder>&>(geom).shape; }

Real extent(const Cylinder& s, Real a)
{
    return s.half_length * std::fabs(a) + s.radius * std::sqrt(std::max(Real(0), 1 - a * a));
}

Aabb aabb(Geom& geom)
{
    const Cylinder& s = shape(geom);
    const Vec3 c = load(geom.position), a = load_mat(geom.rotation).column(2);
    const Vec3 e{extent(s, a.x), extent(s, a.y), extent(s, a.z)};
    return {c - e, c + e};
}

bool zero_sized(const Geom& geom) { return shape(geom).radius == 0 || shape(geom).half_length == 0; }

bool legal(Real radius, Real length)
{
    return usable(radius) && usable(length) && radius >= 0 && length >= 0;
}

CoreSize core_size(const Geom& geom)
{
    const Cylinder& c = shape(geom);
    return {std::sqrt(c.radius * c.radius + c.half_length * c.half_length), 0};
}
Real core_reach(const Geom& geom, Vec3 d)
{
    return shape(geom).radius * std::sqrt(d.x * d.x + d.y * d.y) + shape(geom).half_length * std::fabs(d.z);
}
Real half_thickness(const Geom& geom)
{
    const Cylinder& c = shape(geom);
    return thickness_at_least(std::min(c.radius, c.half_length), std::max(c.radius, c.half_length));
}

void describe_cylinder(const Geom& geom, DifWriter& out)
{
    out.text("type", "cylinder");
    out.real("radius", shape(geom).radius);
    out.real("length", 2 * shape(geom).half_length);
}

RevolvedSolid round_solid(const Geom& geom)
{
    const Cylinder& c = shape(geom);
    RevolvedSolid out;
    out.add_cylinder(-c.half_length, c.half_length, c.radius);
    return out;
}

constexpr SolidType kSolid = {.view = view_of_shape<Cylinder>,
                              .core_reach = core_reach,
                              .core_size = core_size,
                              .round_solid = round_solid};

}  // namespace

const GeomType kCylinderType = {.number = dCylinderClass,
                                .aabb = aabb,
                                .zero_sized = zero_sized,
                                .destroy = destroy_pooled<ShapeGeom<Cylinder>>,
                                .describe = describe_cylinder,
                                .solid = &kSolid,
                                .half_thickness = half_thickness,
                                .create = create_pooled<ShapeGeom<Cylinder>>,
                                .structure = structure_of_sizes<Cylinder>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateCylinder(dSpaceID space, dReal radius, dReal length)
{
    EPODE_USER(legal(radius, length), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Cylinder{radius, length / 2});
}

extern "C" void dGeomCylinderSetParams(dGeomID cylinder, dReal radius, dReal length)
{
    EPODE_GEOM_AS(Cylinder, geom, cylinder);
    EPODE_USER(legal(radius, length));
    EPODE_UNLOCKED(geom);
    geom->shape = {radius, length / 2};
    mark_changed(*geom);
}

extern "C" void dGeomCylinderGetParams(dGeomID cylinder, dReal* radius, dReal* length)
{
    EPODE_GEOM_AS(Cylinder, geom, cylinder);
    EPODE_USER(radius && length);
    *radius = geom->shape.radius;
    *length = 2 * geom->shape.half_length;
}
