// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cone of radius R and length L about the local z axis, its origin the centre of mass: the base lies at
// z = -L/4, the apex at z = 3L/4. With rho the distance from the axis:
//   side      normal (L, R) / s in the half plane (rho, z), s = sqrt(R^2 + L^2); it shows a straight line
//   support   along (u, w): the apex where w L > u R, else the rim
//   ball      the largest inside has the radius R L / (R + s)
//   mass      m = density pi R^2 L / 3, I_z = 3 m R^2 / 10, I_x = m (3 R^2 / 20 + 3 L^2 / 80)
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"
#include "geometry/inertia.h"
#include "ode/mass.h"

#include <algorithm>

namespace epode {

struct Cone {
    Real radius = 1, length = 1;
    Real top() const { return Real(0.75) * length; }
    Real bottom() const { return Real(-0.25) * length; }
    Real slant() const { return std::sqrt(radius * radius + length * length); }
};

namespace {

const Cone& shape(const Geom& geom) { return static_cast<const ShapeGeom<Cone>&>(geom).shape; }
Real from_axis(Vec3 p) { return std::sqrt(p.x * p.x + p.y * p.y); }

// Along the axis, whose direction rounding decides: the middle of the base.
Vec3 rim_point(const Cone& c, Vec3 d)
{
    const Real rho = from_axis(d);
    if (!(rho > 4 * kEpsilon * std::fabs(d.z))) return {0, 0, c.bottom()};
    return {c.radius * d.x / rho, c.radius * d.y / rho, c.bottom()};
}

Vec3 support(const void* of, Vec3 d)
{
    const Cone& c = *static_cast<const Cone*>(of);
    if (d.z * c.length > c.radius * from_axis(d)) return {0, 0, c.top()};
    return rim_point(c, d);
}

// The base or the line of the side, whichever looks along d; a point of the rim when both do.
void feature(const void* of, Vec3 d, Polygon& out)
{
    const Cone& c = *static_cast<const Cone*>(of);
    const Real rho = from_axis(d), size = length(d), s = c.slant();
    const Real lean_base = size + d.z,
               lean_side = s > 0 ? size - (c.length * rho + c.radius * d.z) / s : size;
    if (lean_alike(std::min(lean_base, lean_side), std::max(lean_base, lean_side), size))
        return out.add(rim_point(c, d));
    if (lean_base < lean_side) return add_disc(c.radius, c.bottom(), -1, out);
    if (rho > 4 * kEpsilon * size) out.add(rim_point(c, d));
    out.add({0, 0, c.top()});
}

ConvexView view(const Geom& geom, const Pose& pose)
{
    const Cone& c = shape(geom);
    const Real rim = std::sqrt(c.radius * c.radius + c.bottom() * c.bottom());
    return {.shape = &c,
            .kind = SolidKind::kCurved,
            .base_axes = 4,
            .local_support = support,
            .local_feature = feature,
            .pose = pose,
            .size = std::max(rim, c.top()),
            .rim_radius = c.radius};
}

bool zero_sized(const Geom& geom) { return shape(geom).radius == 0 || shape(geom).length == 0; }

Real half_thickness(const Geom& geom)
{
    const Cone& c = shape(geom);
    const Real sum = c.radius + c.slant();
    return thickness_at_least(sum > 0 ? c.radius * c.length / sum : Real(0), std::max(c.radius, c.length));
}

// Positive inside. Both in the half plane (rho, z), r being the distance from the axis.
Real depth_at(const Cone& c, Real r, Real z)
{
    const Real s = c.slant(), up = z - c.bottom();
    if (!(s > 0)) return -std::sqrt(r * r + up * up);
    const Real in = (c.length * (c.radius - r) - c.radius * up) / s;  // behind the side
    if (in >= 0 && up >= 0) return std::min(in, up);
    const auto from = [&](Real x, Real y) { return -std::sqrt((r - x) * (r - x) + (up - y) * (up - y)); };
    const Real along = (c.radius * (c.radius - r) + c.length * up) / s;  // of the side, from the rim
    if (up < 0 && r <= c.radius) return up;
    if (along <= 0) return from(c.radius, 0);
    return along >= s ? from(0, c.length) : in;
}

MassProperties solid_cone(Real mass, int axis, Real radius, Real length)
{
    const Real along = Real(0.3) * mass * radius * radius;
    const Real across = along / 2 + Real(0.0375) * mass * length * length;
    MassProperties p = {mass, {}, {across, across, across}};
    (axis == 0 ? p.inertia.xx : axis == 1 ? p.inertia.yy : p.inertia.zz) = along;
    return p;
}

bool legal(Real radius, Real length)
{
    return usable(radius) && usable(length) && radius >= 0 && length >= 0;
}

void describe_cone(const Geom& geom, DifWriter& out)
{
    out.text("type", "cone");
    out.real("radius", shape(geom).radius);
    out.real("length", shape(geom).length);
}

RevolvedSolid round_solid(const Geom& geom)
{
    const Cone& c = shape(geom);
    RevolvedSolid out;
    out.add_frustum(c.bottom(), c.top(), c.radius, 0);
    return out;
}

constexpr SolidType kSolid = {.view = view, .round_solid = round_solid};

}  // namespace

const GeomType kConeType = {.number = dConeClass,
                            .aabb = box_by_view,
                            .zero_sized = zero_sized,
                            .destroy = destroy_pooled<ShapeGeom<Cone>>,
                            .describe = describe_cone,
                            .solid = &kSolid,
                            .half_thickness = half_thickness,
                            .create = create_pooled<ShapeGeom<Cone>>,
                            .structure = structure_of_sizes<Cone>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateCone(dSpaceID space, dReal radius, dReal length)
{
    EPODE_USER(legal(radius, length), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Cone{radius, length});
}

extern "C" void dGeomConeSetParams(dGeomID cone, dReal radius, dReal length)
{
    EPODE_GEOM_AS(Cone, geom, cone);
    EPODE_USER(legal(radius, length));
    EPODE_UNLOCKED(geom);
    geom->shape = {radius, length};
    mark_changed(*geom);
}

extern "C" void dGeomConeGetParams(dGeomID cone, dReal* radius, dReal* length)
{
    EPODE_GEOM_AS(Cone, geom, cone);
    EPODE_USER(radius && length);
    *radius = geom->shape.radius;
    *length = geom->shape.length;
}

extern "C" dReal dGeomConePointDepth(dGeomID cone, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Cone, geom, cone, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    const Vec3 q = pose_of(*geom).to_local({x, y, z});
    return depth_at(geom->shape, from_axis(q), q.z);
}

extern "C" void dMassSetConeTotal(dMass* m, dReal total_mass, int direction, dReal radius, dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(direction >= 1 && direction <= 3, "bad direction number");
    const MassProperties p = solid_cone(total_mass, direction - 1, radius, length);
    EPODE_USER(m && usable(p));
    put_mass(m, p);
}

extern "C" void dMassSetCone(dMass* m, dReal density, int direction, dReal radius, dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(direction >= 1 && direction <= 3, "bad direction number");
    const Real mass = density * kPi / 3 * radius * radius * length;
    const MassProperties p = solid_cone(mass, direction - 1, radius, length);
    EPODE_USER(m && usable(p));
    put_mass(m, p);
}
