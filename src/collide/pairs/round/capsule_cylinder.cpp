// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Capsule against cylinder. The axis of the capsule outside the cylinder: the distance of a point moving
// along the axis to the cylinder is a convex function of the parameter, and its least value is found by a
// bracketed root of the slope; exact where GJK would crawl round the rim. Axis inside: the general answer,
// polished to rounding.
#include "collide/pairs/pairs.h"
#include "geometry/overlap/epa.h"
#include "geometry/root.h"

namespace epode {

namespace {

// In the cylinder's frame.
struct CapsuleInCylinder {
    Vec3 from, d;
    Cylinder cylinder;

    // From the nearest point of the cylinder to the point at t.
    Vec3 outward(Real t) const
    {
        const Vec3 p = from + t * d;
        const Real rho = std::sqrt(p.x * p.x + p.y * p.y);
        const Real k = rho > cylinder.radius ? 1 - cylinder.radius / rho : Real(0);
        const Real h = cylinder.half_length;
        return {k * p.x, k * p.y, p.z > h ? p.z - h : p.z < -h ? p.z + h : Real(0)};
    }
    Real slope(Real t) const { return dot(d, outward(t)); }
};

// Least distance over t in [0, 1]; of several equally near points any one will do, the manifold spreads them.
Real nearest(const CapsuleInCylinder& c)
{
    const Real at_from = c.slope(0), at_to = c.slope(1);
    if (at_from >= 0) return 0;
    if (at_to <= 0) return 1;
    return rising_root([&c](Real t) { return c.slope(t); }, 0, at_from, 1, at_to);
}

}  // namespace

void capsule_cylinder(const Capsule& a, const Pose& A, const Cylinder& b, const Pose& B, ContactSink& sink)
{
    const Vec3 reach = a.half_length * A.R.column(2);
    const CapsuleInCylinder c = {B.to_local(A.p - reach), 2 * transposed_times(B.R, reach), b};
    const Real t = nearest(c);
    Vec3 n = c.outward(t);
    const Real distance = length(n);
    if (distance > a.radius) return;
    const ConvexView va = view_of(a, A), vb = view_of(b, B);
    const Real noise = 64 * kEpsilon * (va.size + vb.size + length(c.from));
    if (distance > noise && normalize(n)) {
        convex_manifold(va, vb, B.R * n, -distance, sink);
        return;
    }
    const Overlap o = least_overlap(va, vb);
    convex_manifold(va, vb, o.normal, o.depth, sink);
}

}  // namespace epode
