// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tapered capsule: the hull of two balls, of radius r1 about (0, 0, z1) and r2 about (0, 0, z2 = z1 + L), the
// origin being the centre of mass. The balls' common tangents lean by the angle a, sin a = (r1 - r2) / L, so
// the side has the normal (cos a, sin a) in the half plane (rho, z). Where L <= |r1 - r2| one ball holds the
// other, and is all.
//   core      the same with both radii less by the lesser one, which becomes the radius around it
//   depth     along the tangent's direction (-sin a, cos a) the side ends where the balls begin
//   mass      of a solid of revolution, pi rho^2 dz: pieces of balls and of a cone, on each of which rho^2,
//             rho^4 and rho^2 z^2 are polynomials of degree 4 at most, which 3 points of Gauss integrate
//             exactly
#include "base/float_environment.h"
#include "collide/describe.h"
#include "collide/solid_type.h"
#include "collide/types/registry.h"
#include "geometry/immersion/revolved_solid.h"
#include "geometry/inertia.h"
#include "ode/mass.h"

#include <algorithm>

namespace epode {

struct TaperedCapsule {
    Real r1 = 1, r2 = 1, length = 1;
    Real z1 = 0;  // follows from these

    Real z2() const { return z1 + length; }
    bool is_ball() const { return length <= std::fabs(r1 - r2); }
    Real sine() const { return (r1 - r2) / length; }
    Real cosine() const { return std::sqrt(std::max(Real(0), 1 - sine() * sine())); }
};

namespace {

const TaperedCapsule& shape(const Geom& geom)
{
    return static_cast<const ShapeGeom<TaperedCapsule>&>(geom).shape;
}
Real from_axis(Vec3 p) { return std::sqrt(p.x * p.x + p.y * p.y); }
Real lesser(const TaperedCapsule& c) { return std::min(c.r1, c.r2); }

Vec3 support(const void* of, Vec3 d)
{
    const TaperedCapsule& c = *static_cast<const TaperedCapsule*>(of);
    const Real size = length(d);
    const bool first = c.z1 * d.z + c.r1 * size > c.z2() * d.z + c.r2 * size;
    const Real r = (first ? c.r1 : c.r2) - lesser(c);
    return Vec3{0, 0, first ? c.z1 : c.z2()} + r * normalized_or(d, {});
}

// The line of the side that looks along d; the farthest point where none does nearly.
void feature(const void* of, Vec3 d, Polygon& out)
{
    constexpr Real kNearly = Real(0.9);
    const TaperedCapsule& c = *static_cast<const TaperedCapsule*>(of);
    const Real rho = from_axis(d);
    if (c.is_ball() || !(rho > 0)) return out.add(support(of, d));
    const Vec3 n{c.cosine() * d.x / rho, c.cosine() * d.y / rho, c.sine()};
    if (dot(n, d) < kNearly * length(d)) return out.add(support(of, d));
    out.add(Vec3{0, 0, c.z1} + (c.r1 - lesser(c)) * n);
    out.add(Vec3{0, 0, c.z2()} + (c.r2 - lesser(c)) * n);
}

ConvexView view(const Geom& geom, const Pose& pose)
{
    const TaperedCapsule& c = shape(geom);
    return {.shape = &c,
            .kind = SolidKind::kCurved,
            .local_support = support,
            .local_feature = feature,
            .pose = pose,
            .radius = lesser(c),
            .size = std::max(std::fabs(c.z1) + c.r1, std::fabs(c.z2()) + c.r2) - lesser(c)};
}

bool zero_sized(const Geom& geom) { return shape(geom).r1 == 0 && shape(geom).r2 == 0; }

Real half_thickness(const Geom& geom)
{
    const TaperedCapsule& c = shape(geom);
    return std::max(c.r1, c.r2);
}

// Positive inside.
Real depth_at(const TaperedCapsule& c, Real rho, Real z)
{
    const auto in_ball = [&](Real r, Real at) { return r - std::sqrt(rho * rho + (z - at) * (z - at)); };
    if (c.is_ball()) return c.r1 > c.r2 ? in_ball(c.r1, c.z1) : in_ball(c.r2, c.z2());
    const Real s = c.sine(), k = c.cosine(), up = z - c.z1, along = k * up - s * rho;
    if (along <= 0) return in_ball(c.r1, c.z1);
    return along >= c.length * k ? in_ball(c.r2, c.z2()) : c.r1 - (k * rho + s * up);
}

// Integrals over z of pi rho^2, times z and z^2, and of pi rho^4.
struct Moments {
    Real volume = 0, first = 0, second = 0, fourth = 0;

    template <typename Rho2>
    void add(Real from, Real to, const Rho2& rho2_at)
    {
        constexpr Real kPlace = Real(0.77459666924148337704);  // sqrt(3 / 5)
        const Real middle = (from + to) / 2, half = (to - from) / 2;
        if (!(half > 0)) return;
        for (const Real x : {-kPlace, Real(0), kPlace}) {
            const Real z = middle + x * half, r2 = rho2_at(z);
            const Real part = kPi * half * (x == 0 ? Real(8) : Real(5)) / 9;
            volume += part * r2, first += part * r2 * z, second += part * r2 * z * z,
                fourth += part * r2 * r2;
        }
    }
};

// About the middle of the first ball.
Moments moments_of(Real r1, Real r2, Real length)
{
    const TaperedCapsule c{r1, r2, length, 0};
    const auto ball = [](Real r, Real at) {
        return [r, at](Real z) { return std::max(Real(0), r * r - (z - at) * (z - at)); };
    };
    Moments m;
    if (c.is_ball()) {
        const Real r = std::max(r1, r2), at = r1 > r2 ? Real(0) : length;
        m.add(at - r, at + r, ball(r, at));
        return m;
    }
    const Real s = c.sine(), k = c.cosine(), low = r1 * s, high = length + r2 * s;
    m.add(-r1, low, ball(r1, 0));
    m.add(low, high, [&](Real z) {
        const Real rho = k * (r1 + (r2 - r1) * (z - low) / (high - low));
        return rho * rho;
    });
    m.add(high, length + r2, ball(r2, length));
    return m;
}

TaperedCapsule made(Real r1, Real r2, Real length)
{
    // By a solid of size 1: of a large or tiny one the volume is no number.
    const Real size = std::max(std::max(r1, r2), length);
    const Moments m = size > 0 ? moments_of(r1 / size, r2 / size, length / size) : Moments{};
    return {r1, r2, length, m.volume > 0 ? -size * m.first / m.volume : -length / 2};
}

// What follows from the three sizes is computed again, with the same bits.
void structure(Geom& geom, ShapeStream& stream)
{
    TaperedCapsule& c = static_cast<ShapeGeom<TaperedCapsule>&>(geom).shape;
    stream.sizes(&c.r1, 1), stream.sizes(&c.r2, 1), stream.sizes(&c.length, 1);
    if (stream.loads()) c = made(c.r1, c.r2, c.length);
}

MassProperties solid_tapered_capsule(Real mass, int axis, const Moments& m)
{
    const Real per = mass / m.volume, along = per * m.fourth / 2;
    const Real across = along / 2 + per * (m.second - m.first * m.first / m.volume);
    MassProperties p = {mass, {}, {across, across, across}};
    (axis == 0 ? p.inertia.xx : axis == 1 ? p.inertia.yy : p.inertia.zz) = along;
    return p;
}

bool legal(Real r1, Real r2, Real length)
{
    return usable(r1) && usable(r2) && usable(length) && r1 >= 0 && r2 >= 0 && length >= 0;
}

void describe_tapered_capsule(const Geom& geom, DifWriter& out)
{
    const TaperedCapsule& c = shape(geom);
    out.text("type", "tapered capsule");
    out.list("radii", {c.r1, c.r2});
    out.real("length", c.length);
}

// The ends of the cone where it touches the balls.
RevolvedSolid round_solid(const Geom& geom)
{
    const TaperedCapsule& c = shape(geom);
    RevolvedSolid out;
    if (c.is_ball()) {
        const Real r = std::max(c.r1, c.r2), z = c.r1 > c.r2 ? c.z1 : c.z2();
        out.add_ball(z - r, z + r, z, r);
        return out;
    }
    const Real s = c.sine(), k = c.cosine(), low = c.z1 + c.r1 * s, high = c.z2() + c.r2 * s;
    out.add_ball(c.z1 - c.r1, low, c.z1, c.r1);
    out.add_frustum(low, high, c.r1 * k, c.r2 * k);
    out.add_ball(high, c.z2() + c.r2, c.z2(), c.r2);
    return out;
}

constexpr SolidType kSolid = {.view = view, .round_solid = round_solid};

}  // namespace

const GeomType kTaperedCapsuleType = {.number = dTaperedCapsuleClass,
                                      .aabb = box_by_view,
                                      .zero_sized = zero_sized,
                                      .destroy = destroy_pooled<ShapeGeom<TaperedCapsule>>,
                                      .describe = describe_tapered_capsule,
                                      .solid = &kSolid,
                                      .half_thickness = half_thickness,
                                      .create = create_pooled<ShapeGeom<TaperedCapsule>>,
                                      .structure = structure};

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateTaperedCapsule(dSpaceID space, dReal r1, dReal r2, dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER(legal(r1, r2, length), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    return create_shape(space, made(r1, r2, length));
}

extern "C" void dGeomTaperedCapsuleSetParams(dGeomID tapered_capsule, dReal r1, dReal r2, dReal length)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(TaperedCapsule, geom, tapered_capsule);
    EPODE_USER(legal(r1, r2, length));
    EPODE_UNLOCKED(geom);
    geom->shape = made(r1, r2, length);
    mark_changed(*geom);
}

extern "C" void dGeomTaperedCapsuleGetParams(dGeomID tapered_capsule, dReal* r1, dReal* r2, dReal* length)
{
    EPODE_GEOM_AS(TaperedCapsule, geom, tapered_capsule);
    EPODE_USER(r1 && r2 && length);
    *r1 = geom->shape.r1, *r2 = geom->shape.r2;
    *length = geom->shape.length;
}

extern "C" dReal dGeomTaperedCapsulePointDepth(dGeomID tapered_capsule, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_GEOM_AS(TaperedCapsule, geom, tapered_capsule, 0);
    EPODE_USER(usable(x) && usable(y) && usable(z), 0);
    const Vec3 q = pose_of(*geom).to_local({x, y, z});
    return depth_at(geom->shape, from_axis(q), q.z);
}

extern "C" void dMassSetTaperedCapsuleTotal(dMass* m, dReal total_mass, int direction, dReal r1, dReal r2,
                                            dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(direction >= 1 && direction <= 3, "bad direction number");
    EPODE_USER(m && legal(r1, r2, length));
    const Moments moments = moments_of(r1, r2, length);
    EPODE_USER_SAY(moments.volume > 0, "tapered capsule has no volume");
    const MassProperties p = solid_tapered_capsule(total_mass, direction - 1, moments);
    EPODE_USER(usable(p));
    put_mass(m, p);
}

extern "C" void dMassSetTaperedCapsule(dMass* m, dReal density, int direction, dReal r1, dReal r2,
                                       dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(direction >= 1 && direction <= 3, "bad direction number");
    EPODE_USER(m && legal(r1, r2, length));
    const Moments moments = moments_of(r1, r2, length);
    EPODE_USER_SAY(moments.volume > 0, "tapered capsule has no volume");
    const MassProperties p = solid_tapered_capsule(density * moments.volume, direction - 1, moments);
    EPODE_USER(usable(p));
    put_mass(m, p);
}
