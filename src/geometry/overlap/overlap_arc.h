// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The overlap of a round core (axis z, radius R, half height H) with something straight along the unit vector
// e, while n turns about e. With n outward from the latter, v on it,
//   h(n) = n.v + R |(nx, ny)| + H |nz|
// is the overlap, and its slope as n turns is that of the support point s = v + (R nx / rho, R ny / rho,
// +-H). With n ~ m + t q, q = e x m, the slope has the sign of s.q - t s.m. What turns about e is seen as an
// ellipse between two straight lines, and the second derivative by the angle is k - h, where
//   k = R (e.z)^2 / |(nx, ny)|^3
// is the ellipse's radius of curvature. From where n comes nearest to the axis to where nz = 0 it falls; so h
// is cupped first and then arched, and has one valley at most, on the near side of where k = h.
#pragma once

#include "geometry/root.h"
#include "math/vec.h"

namespace epode {

// The normals of an edge, in the core's frame.
struct Arc {
    Vec3 at, m, q;
    Real radius, half_length;
    static constexpr int kSteps = 12;  // to find a rise that is hardly there

    Vec3 direction(Real t) const { return m + t * q; }
    Real overlap(Real t) const
    {
        const Vec3 n = direction(t);
        const Real size = std::sqrt(1 + t * t);
        return (dot(n, at) + radius * std::sqrt(n.x * n.x + n.y * n.y) + half_length * std::fabs(n.z)) / size;
    }
    bool cupped(Real t) const
    {
        const Vec3 n = direction(t);
        const Real size = std::sqrt(1 + t * t), across = std::sqrt(n.x * n.x + n.y * n.y) / size;
        const Real along = m.x * q.y - m.y * q.x;
        return radius * along * along > overlap(t) * across * across * across;
    }
    // `up`: 1 or -1, the sign of nz on this side.
    Real slope(Real t, Real up) const
    {
        const Vec3 n = direction(t);
        const Real rho = std::sqrt(n.x * n.x + n.y * n.y), k = rho > 0 ? radius / rho : Real(0);
        const Vec3 s = at + Vec3{k * n.x, k * n.y, up * half_length};
        return dot(s, q) - t * dot(s, m);
    }
};

// The valley of the arc from t0 to t1, a piece of one quarter; false when the least value is at an end.
inline bool valley(const Arc& arc, Real t0, Real t1, Real& t)
{
    const Real up = arc.direction(Real(0.5) * (t0 + t1)).z < 0 ? -1 : 1;
    const auto slope = [&](Real x) { return arc.slope(x, up); };
    const auto steep = [&](Real x) { return std::fabs(arc.direction(x).z) / std::sqrt(1 + x * x); };
    const bool forward = steep(t0) >= steep(t1);
    const Real near = forward ? t0 : t1, way = forward ? 1 : -1;
    const Real at_near = slope(near);
    if (!(way * at_near < 0)) return false;
    Real far = forward ? t1 : t0, at_far = slope(far);
    if (way * at_far < 0) {  // it comes down again, or never rose: look where it rises most
        if (!arc.cupped(near) || arc.cupped(far)) return false;
        Real cup = near, arch = far;
        for (int k = 0; k < Arc::kSteps && way * at_far < 0; ++k) {
            far = Real(0.5) * (cup + arch), at_far = slope(far);
            (arc.cupped(far) ? cup : arch) = far;
        }
        if (way * at_far < 0) return false;
    }
    t = forward ? rising_root(slope, near, at_near, far, at_far)
                : rising_root(slope, far, at_far, near, at_near);
    return true;
}

// The places that cut an arc into pieces, in order: those above, and two so that t measures a wide one
// evenly.
struct Cuts {
    Real t[6];
    int count = 0;
    void insert(Real value)
    {
        int i = count++;
        for (; i > 0 && t[i - 1] > value; --i) t[i] = t[i - 1];
        t[i] = value;
    }
};

template <class Offer>
void try_arc(const Arc& arc, Real half, const Offer& offer)
{
    const Real level = arc.q.z != 0 ? -arc.m.z / arc.q.z : kInf;
    const bool has_level = level > -half && level < half;
    if (has_level) offer(arc.direction(level), arc.overlap(level));
    if (!(arc.radius > 0)) return;
    Cuts cuts;
    cuts.insert(-half), cuts.insert(half);
    if (has_level) cuts.insert(level);
    const Real steepest = arc.m.z != 0 ? arc.q.z / arc.m.z : kInf;
    if (steepest > -half && steepest < half) cuts.insert(steepest);
    if (half > 1) cuts.insert(-1), cuts.insert(1);
    for (int i = 0; i + 1 < cuts.count; ++i) {
        Real t;
        if (cuts.t[i] < cuts.t[i + 1] && valley(arc, cuts.t[i], cuts.t[i + 1], t))
            offer(arc.direction(t), arc.overlap(t));
    }
}

}  // namespace epode
