// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sphere: |x| <= radius.
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"

namespace epode {
namespace {

const Sphere& shape(const Geom& geom) { return static_cast<const ShapeGeom<Sphere>&>(geom).shape; }

Aabb aabb(Geom& geom)
{
    const Real r = shape(geom).radius;
    const Vec3 c = load(geom.position), e{r, r, r};
    return {c - e, c + e};
}

bool zero_sized(const Geom& geom) { return shape(geom).radius == 0; }

CoreSize core_size(const Geom& geom) { return {0, shape(geom).radius}; }
Real core_reach(const Geom&, Vec3) { return 0; }
Real half_thickness(const Geom& geom) { return shape(geom).radius; }

void describe_sphere(const Geom& geom, DifWriter& out)
{
    out.text("type", "sphere");
    out.real("radius", shape(geom).radius);
}

RevolvedSolid round_solid(const Geom& geom)
{
    const Real r = shape(geom).radius;
    return RevolvedSolid::ellipsoid({r, r, r});
}

constexpr SolidType kSolid = {.view = view_of_shape<Sphere>,
                              .core_reach = core_reach,
                              .core_size = core_size,
                              .round_solid = round_solid};

}  // namespace

const GeomType kSphereType = {.number = dSphereClass,
                              .aabb = aabb,
                              .zero_sized = zero_sized,
                              .destroy = destroy_pooled<ShapeGeom<Sphere>>,
                              .describe = describe_sphere,
                              .solid = &kSolid,
                              .half_thickness = half_thickness,
                              .create = create_pooled<ShapeGeom<Sphere>>,
                              .structure = structure_of_sizes<Sphere>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateSphere(dSpaceID space, dReal radius)
{
    EPODE_USER(usable(radius) && radius >= 0, nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Sphere{radius});
}

extern "C" void dGeomSphereSetRadius(dGeomID sphere, dReal radius)
{
    EPODE_GEOM_AS(Sphere, geom, sphere);
    EPODE_USER(usable(radius) && radius >= 0);
    EPODE_UNLOCKED(geom);
    geom->shape.radius = radius;
    mark_changed(*geom);
}

extern "C" dReal dGeomSphereGetRadius(dGeomID sphere)
{
    EPODE_GEOM_AS(Sphere, geom, sphere, 0);
    return geom->shape.radius;
}

extern "C" dReal dGeomSpherePointDepth(dGeomID sphere, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Sphere, geom, sphere, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    return geom->shape.radius - length(Vec3{x, y, z} - pose_of(*geom).p);
}
