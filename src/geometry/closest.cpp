// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closest points: see closest.h. Degenerate segments (points) fall out of the clamping without special cases
// other than a division that must not happen.
#include "geometry/closest.h"

namespace epode {

namespace {

constexpr Real clamp01(Real t) { return t > 0 ? (t < 1 ? t : Real(1)) : Real(0); }

// Half the derivative of the squared distance to the box at parameter t.
Real slope(Vec3 a, Vec3 d, Vec3 half, Real t)
{
    const Vec3 p = a + t * d;
    return dot(d, p - clamp_to_box(p, half));
}

struct Breaks {
    Real t[8];
    int count = 0;
    void insert(Real value)
    {
        if (!(value > 0 && value < 1)) return;
        int i = count++;
        for (; i > 0 && t[i - 1] > value; --i) t[i] = t[i - 1];
        t[i] = value;
    }
};

}  // namespace

Real closest_on_segment(Vec3 a, Vec3 b, Vec3 p)
{
    const Vec3 d = b - a;
    const Real dd = length2(d);
    return dd > 0 ? clamp01(dot(p - a, d) / dd) : Real(0);
}

void closest_segment_points(Vec3 a1, Vec3 a2, Vec3 b1, Vec3 b2, Vec3& p, Vec3& q)
{
    const Vec3 u = a2 - a1, v = b2 - b1, r = a1 - b1;
    const Real uu = length2(u), vv = length2(v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    const Real det = uu * vv - uv * uv;  // |u|^2 |v|^2 sin^2
    Real s = 0;
    if (det > 16 * kEpsilon * uu * vv) s = clamp01((uv * vr - ur * vv) / det);
    Real t = vv > 0 ? (uv * s + vr) / vv : Real(0);
    if (t < 0 || t > 1) t = clamp01(t);
    s = uu > 0 ? clamp01((uv * t - ur) / uu) : Real(0);
    p = a1 + s * u;
    q = b1 + t * v;
}

Real closest_to_box(Vec3 a, Vec3 b, Vec3 half)
{
    const Vec3 d = b - a;
    Breaks breaks;
    for (int i = 0; i < 3; ++i) {
        if (d[i] == 0) continue;
        breaks.insert((-half[i] - a[i]) / d[i]);
        breaks.insert((half[i] - a[i]) / d[i]);
    }
    breaks.t[breaks.count++] = 1;
    // The slope rises with t: find where it stops being negative, and where it starts being positive.
    const Real flat = 4 * kEpsilon * length2(d);
    Real left = 0, at_left = slope(a, d, half, 0);
    if (at_left > flat) return 0;
    Real enter = at_left >= -flat ? Real(0) : Real(-1);
    for (int i = 0; i < breaks.count; ++i) {
        const Real right = breaks.t[i], at_right = slope(a, d, half, right);
        if (enter < 0 && at_right >= -flat)
            enter =
                at_right > at_left ? left + (right - left) * clamp01(-at_left / (at_right - at_left)) : right;
        if (enter >= 0 && at_right > flat) {
            const Real leave = left + (right - left) * clamp01(-at_left / (at_right - at_left));
            return Real(0.5) * (enter + (leave > enter ? leave : enter));
        }
        left = right;
        at_left = at_right;
    }
    return enter >= 0 ? Real(0.5) * (enter + 1) : Real(1);
}

}  // namespace epode
