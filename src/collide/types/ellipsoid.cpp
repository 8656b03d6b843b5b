// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ellipsoid with the half axes r_i: sum (x_i / r_i)^2 <= 1.
//   support   along n: x_i = r_i^2 n_i / sqrt(sum (r_k n_k)^2)
//   nearest   to a point p, x with p - x normal to the surface there: x_i = r_i^2 p_i / (r_i^2 + t), t the
//             root of F(t) = sum (r_i p_i / (r_i^2 + t))^2 - 1, which falls for t > -min r_i^2. Where F has
//             none, p lies on the plane across the shortest axis, and x is off it.
//   mass      m = density 4 pi r_x r_y r_z / 3, I_x = m (r_y^2 + r_z^2) / 5 and so on
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"
#include "geometry/inertia.h"
#include "geometry/root.h"
#include "ode/mass.h"

#include <algorithm>

namespace epode {

struct Ellipsoid {
    Vec3 radii{1, 1, 1};
};

namespace {

const Vec3& radii(const Geom& geom) { return static_cast<const ShapeGeom<Ellipsoid>&>(geom).shape.radii; }
Real least(Vec3 a) { return std::min(std::min(a.x, a.y), a.z); }

Vec3 support(const void* of, Vec3 d)
{
    const Vec3 r = static_cast<const Ellipsoid*>(of)->radii, along = scale(r, d);
    const Real size = length(along);
    return size > 0 ? (1 / size) * scale(r, along) : Vec3{};
}

void feature(const void* of, Vec3 d, Polygon& out) { out.add(support(of, d)); }

ConvexView view(const Geom& geom, const Pose& pose)
{
    return {.shape = &static_cast<const ShapeGeom<Ellipsoid>&>(geom).shape,
            .kind = SolidKind::kCurved,
            .local_support = support,
            .local_feature = feature,
            .pose = pose,
            .size = max_component(radii(geom))};
}

Real core_reach(const Geom& geom, Vec3 d) { return length(scale(radii(geom), d)); }
CoreSize core_size(const Geom& geom) { return {max_component(radii(geom)), 0}; }

bool zero_sized(const Geom& geom) { return least(radii(geom)) == 0; }

Real half_thickness(const Geom& geom)
{
    return thickness_at_least(least(radii(geom)), max_component(radii(geom)));
}

// Of p, no coordinate of which is negative, and radii all above zero: the nearest point of the surface.
// u = 1 + t / m^2 is sought, m being the least radius, so that all numbers are of the solid's size.
Vec3 nearest_to(Vec3 p, Vec3 r)
{
    const Real m = least(r);
    const Vec3 k = {r.x / m, r.y / m, r.z / m}, k2 = scale(k, k);
    const auto at = [&](Real u) {
        const auto one = [&](Real ki2, Real pi) { return pi > 0 ? ki2 * pi / (ki2 - 1 + u) : Real(0); };
        return Vec3{one(k2.x, p.x), one(k2.y, p.y), one(k2.z, p.z)};
    };
    const auto inside = [&](Real u) {  // rises with u
        const Vec3 x = at(u);
        return 1 - length2({x.x / r.x, x.y / r.y, x.z / r.z});
    };
    const Real far = 1 + length(scale(k, p)) / m;
    const Real near = 4 * kEpsilon * (1 + length(p) / m) * kEpsilon;
    if (inside(near) < 0)
        return at(rising_root(inside, near, inside(near), far, std::max(inside(far), kEpsilon)));
    Vec3 x = at(near);
    const int shortest = r.x == m ? 0 : r.y == m ? 1 : 2;
    x.set(shortest, 0);
    const Real left = 1 - length2({x.x / r.x, x.y / r.y, x.z / r.z});
    x.set(shortest, m * std::sqrt(left > 0 ? left : Real(0)));
    return x;
}

MassProperties solid_ellipsoid(Real mass, Vec3 r)
{
    const Vec3 r2 = Real(0.2) * mass * scale(r, r);
    return {mass, {}, {r2.y + r2.z, r2.z + r2.x, r2.x + r2.y}};
}

bool legal(Real rx, Real ry, Real rz)
{
    return usable(rx) && usable(ry) && usable(rz) && rx >= 0 && ry >= 0 && rz >= 0;
}

void describe_ellipsoid(const Geom& geom, DifWriter& out)
{
    out.text("type", "ellipsoid");
    out.list("radii", {radii(geom).x, radii(geom).y, radii(geom).z});
}

RevolvedSolid round_solid(const Geom& geom) { return RevolvedSolid::ellipsoid(radii(geom)); }

constexpr SolidType kSolid = {
    .view = view, .core_reach = core_reach, .core_size = core_size, .round_solid = round_solid};

}  // namespace

const GeomType kEllipsoidType = {.number = dEllipsoidClass,
                                 .aabb = box_by_view,
                                 .zero_sized = zero_sized,
                                 .destroy = destroy_pooled<ShapeGeom<Ellipsoid>>,
                                 .describe = describe_ellipsoid,
                                 .solid = &kSolid,
                                 .half_thickness = half_thickness,
                                 .create = create_pooled<ShapeGeom<Ellipsoid>>,
                                 .structure = structure_of_sizes<Ellipsoid>};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateEllipsoid(dSpaceID space, dReal rx, dReal ry, dReal rz)
{
    EPODE_USER(legal(rx, ry, rz), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, Ellipsoid{{rx, ry, rz}});
}

extern "C" void dGeomEllipsoidSetRadii(dGeomID ellipsoid, dReal rx, dReal ry, dReal rz)
{
    EPODE_GEOM_AS(Ellipsoid, geom, ellipsoid);
    EPODE_USER(legal(rx, ry, rz));
    EPODE_UNLOCKED(geom);
    geom->shape.radii = {rx, ry, rz};
    mark_changed(*geom);
}

extern "C" void dGeomEllipsoidGetRadii(dGeomID ellipsoid, dVector3 result)
{
    EPODE_GEOM_AS(Ellipsoid, geom, ellipsoid);
    EPODE_USER(result);
    store(result, geom->shape.radii);
}

extern "C" dReal dGeomEllipsoidPointDepth(dGeomID ellipsoid, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(Ellipsoid, geom, ellipsoid, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    const Vec3 r = geom->shape.radii, p = abs(pose_of(*geom).to_local({x, y, z}));
    EPODE_USER_SAY(least(r) > 0, "ellipsoid has no volume", 0);
    const Real away = length(p - nearest_to(p, r));
    return length2({p.x / r.x, p.y / r.y, p.z / r.z}) > 1 ? -away : away;
}

extern "C" void dMassSetEllipsoidTotal(dMass* m, dReal total_mass, dReal rx, dReal ry, dReal rz)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_ellipsoid(total_mass, {rx, ry, rz});
    EPODE_USER(m && usable(p));
    put_mass(m, p);
}

extern "C" void dMassSetEllipsoid(dMass* m, dReal density, dReal rx, dReal ry, dReal rz)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_ellipsoid(density * 4 * kPi / 3 * rx * ry * rz, {rx, ry, rz});
    EPODE_USER(m && usable(p));
    put_mass(m, p);
}
