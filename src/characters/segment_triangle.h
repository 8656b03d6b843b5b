// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Distance of a segment from a triangle that it does not cross: attained at an end of the segment over the
// triangle's face, or between the segment and an edge (Ericson 2005, 5.1.10). The general search
// (query/separation.h) takes ten times as long, and capsules on meshes are what characters mostly are.
#pragma once

#include "geometry/closest.h"
#include "geometry/triangle.h"

namespace epode {

struct SegmentGap {
    Vec3 on_segment, on_triangle;
    Real distance2 = kInf;
};

inline bool is_over(const Triangle& t, Vec3 p)
{
    for (int k = 0; k < 3; ++k)
        if (dot(cross(t.n, t.edge(k)), p - t.v[k]) < 0) return false;
    return true;
}

// False: they cross, or nearly.
inline bool segment_gap(Vec3 a, Vec3 b, const Triangle& t, SegmentGap& out)
{
    out.distance2 = kInf;
    const Real height[2] = {t.height(a), t.height(b)};
    const Vec3 end[2] = {a, b};
    for (int i = 0; i < 2; ++i) {
        if (!is_over(t, end[i]) || !(height[i] * height[i] < out.distance2)) continue;
        out = {end[i], end[i] - height[i] * t.n, height[i] * height[i]};
    }
    const bool one_sided = height[0] * height[1] > 0;
    if (!one_sided) {
        const Real sum = std::fabs(height[0]) + std::fabs(height[1]);
        if (!(sum > 0) || is_over(t, a + (std::fabs(height[0]) / sum) * (b - a))) return false;
    }
    const int nearer = std::fabs(height[1]) < std::fabs(height[0]);
    if (out.distance2 < kInf && one_sided && out.on_segment == end[nearer]) return true;
    for (int k = 0; k < 3; ++k) {
        Vec3 p, q;
        closest_segment_points(a, b, t.v[k], t.v[(k + 1) % 3], p, q);
        const Real d2 = length2(p - q);
        if (d2 < out.distance2) out = {p, q, d2};
    }
    return true;
}

}  // namespace epode
