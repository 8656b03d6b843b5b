// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closed forms for the primitives. A capsule is a cylinder and two half balls; its half balls, of mass M2
// together, have about the middle the transverse inertia M2 (2/5 r^2 + 3/8 r L + L^2/4): a half ball's
// centre lies 3/8 r beyond the cylinder's end. Shares of mass come from ratios of volumes, so a total mass
// needs no density.
// Meshes: signed tetrahedra from a reference point to each triangle (Lien & Kajiya, "A symbolic method for
// calculating the integral properties of arbitrary nonconvex polyhedra", IEEE CG&A 4(10), 1984):
//   integral of x x^T over (0,a,b,c) = det/120 (s s^T + a a^T + b b^T + c c^T), s = a + b + c.
// Mirtich's projected line integrals give the same numbers with far more cases. The reference point is a
// vertex: about a far origin the sums would cancel.
#include "geometry/inertia.h"

#include "base/check.h"
#include "math/cholesky.h"

namespace epode {
namespace {

Sym3 operator+(const Sym3& a, const Sym3& b)
{
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}

Sym3 operator*(Real s, const Sym3& a) { return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz}; }

Sym3 outer(Vec3 v) { return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z}; }

// tr(S) 1 - S: turns second moments into inertia.
Sym3 inertia_of(const Sym3& S) { return {S.yy + S.zz, S.xx + S.zz, S.xx + S.yy, -S.xy, -S.xz, -S.yz}; }

// A unit point mass at v.
Sym3 point_inertia(Vec3 v) { return inertia_of(outer(v)); }

Sym3 about_axis(int axis, Real along, Real across)
{
    return {axis == 0 ? along : across, axis == 1 ? along : across, axis == 2 ? along : across, 0, 0, 0};
}

}  // namespace

Real sphere_volume(Real radius) { return Real(4) / 3 * kPi * radius * radius * radius; }
Real box_volume(Vec3 sides) { return sides.x * sides.y * sides.z; }
Real cylinder_volume(Real radius, Real length) { return kPi * radius * radius * length; }
Real capsule_volume(Real radius, Real length)
{
    return cylinder_volume(radius, length) + sphere_volume(radius);
}

MassProperties solid_sphere(Real mass, Real radius)
{
    const Real i = Real(0.4) * mass * radius * radius;
    return {mass, {}, {i, i, i, 0, 0, 0}};
}

MassProperties solid_box(Real mass, Vec3 sides)
{
    const Vec3 s = scale(sides, sides);
    const Real k = mass / 12;
    return {mass, {}, {k * (s.y + s.z), k * (s.x + s.z), k * (s.x + s.y), 0, 0, 0}};
}

MassProperties solid_cylinder(Real mass, int axis, Real radius, Real length)
{
    const Real r2 = radius * radius;
    return {mass, {}, about_axis(axis, mass * r2 / 2, mass * (r2 / 4 + length * length / 12))};
}

MassProperties solid_capsule(Real mass, int axis, Real radius, Real length)
{
    // Volumes relate as L : 4/3 r.
    const Real share = length / (length + Real(4) / 3 * radius);
    const Real m1 = mass * share, m2 = mass - m1;
    const Real r2 = radius * radius, l2 = length * length;
    const Real along = (m1 / 2 + Real(0.4) * m2) * r2;
    const Real across =
        m1 * (r2 / 4 + l2 / 12) + m2 * (Real(0.4) * r2 + Real(0.375) * radius * length + l2 / 4);
    return {mass, {}, about_axis(axis, along, across)};
}

MassProperties with_mass(const MassProperties& p, Real mass)
{
    return {mass, p.center, (mass / p.mass) * p.inertia};
}

MassProperties translated(const MassProperties& p, Vec3 offset)
{
    const Vec3 center = p.center + offset;
    const Sym3 shift = p.mass * (point_inertia(center) + Real(-1) * point_inertia(p.center));
    return {p.mass, center, p.inertia + shift};
}

MassProperties rotated(const MassProperties& p, const Mat3& R)
{
    return {p.mass, R * p.center, rotate(R, p.inertia)};
}

MassProperties united(const MassProperties& p, const MassProperties& q)
{
    const Real mass = p.mass + q.mass;
    Vec3 center = p.center;
    if (mass != 0 || p.mass != 0) center = (p.mass * p.center + q.mass * q.center) / mass;
    return {mass, center, p.inertia + q.inertia};
}

MassFault mass_fault(const MassProperties& p)
{
    if (!(p.mass > 0)) return MassFault::kMass;
    if (!positive_definite(p.inertia)) return MassFault::kInertia;
    const Sym3 about_center = p.inertia + (-p.mass) * point_inertia(p.center);
    return positive_definite(about_center) ? MassFault::kNone : MassFault::kCenter;
}

bool usable(const MassProperties& p)
{
    const Sym3& i = p.inertia;
    const Real all[] = {p.mass, p.center.x, p.center.y, p.center.z, i.xx, i.yy, i.zz, i.xy, i.xz, i.yz};
    return usable(all, 10);
}

void MeshMoments::add_triangle(Vec3 a, Vec3 b, Vec3 c)
{
    if (!started_) {
        reference_ = a;
        started_ = true;
    }
    a -= reference_, b -= reference_, c -= reference_;
    const Real det = dot(a, cross(b, c));
    const Vec3 s = a + b + c;
    volume_ += det / 6;
    first_ += det / 24 * s;
    second_ = second_ + (det / 120) * (outer(s) + outer(a) + outer(b) + outer(c));
}

MassProperties MeshMoments::properties(Real density) const
{
    const Vec3 centroid = volume_ != 0 ? first_ / volume_ : Vec3{};
    const MassProperties here = {density * volume_, centroid, density * inertia_of(second_)};
    return translated(here, reference_);
}

}  // namespace epode
