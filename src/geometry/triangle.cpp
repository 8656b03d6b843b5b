// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangle.h.
#include "geometry/triangle.h"

namespace epode {

namespace {

// The first corner among the farthest.
Vec3 triangle_support(const void* shape, Vec3 d)
{
    const Triangle& t = *static_cast<const Triangle*>(shape);
    int best = 0;
    for (int k = 1; k < 3; ++k)
        if (dot(d, t.v[k]) > dot(d, t.v[best])) best = k;
    return t.v[best];
}

void triangle_feature(const void* shape, Vec3 d, Polygon& out)
{
    const Triangle& t = *static_cast<const Triangle*>(shape);
    const bool from_above = dot(d, t.n) >= 0;
    out.add(t.v[0]), out.add(t.v[from_above ? 1 : 2]), out.add(t.v[from_above ? 2 : 1]);
}

Vec3 outward(const Triangle& t, int k, Vec3 direction)
{
    return normalized_or(cross(t.edge(k), direction), Vec3{});
}

}  // namespace

bool make_triangle(Vec3 v0, Vec3 v1, Vec3 v2, Triangle& out)
{
    out.v[0] = v0, out.v[1] = v1, out.v[2] = v2;
    out.n = cross(v1 - v0, v2 - v0);
    if (!normalize(out.n)) return false;
    out.c = dot(out.n, v0);
    return true;
}

ConvexView view_of(const Triangle& triangle)
{
    Real size2 = 0;
    for (const Vec3 v : triangle.v) size2 = length2(v) > size2 ? length2(v) : size2;
    return {.shape = &triangle,
            .local_support = triangle_support,
            .local_feature = triangle_feature,
            .pose = {},
            .radius = 0,
            .size = std::sqrt(size2),
            .face_axes = 0,
            .edge_axes = 0,
            .rim_radius = 0};
}

Real longest_edge(const Triangle& t)
{
    Real longest2 = 0;
    for (int k = 0; k < 3; ++k) {
        const Real e2 = length2(t.edge(k));
        longest2 = e2 > longest2 ? e2 : longest2;
    }
    return std::sqrt(longest2);
}

Stretch within_prism(const Triangle& triangle, Vec3 direction, Vec3 a, Vec3 b, Real slack)
{
    Stretch s;
    for (int k = 0; k < 3; ++k) {
        const Vec3 m = outward(triangle, k, direction);
        const Real at_a = dot(m, a - triangle.v[k]) - slack, at_b = dot(m, b - triangle.v[k]) - slack;
        if (at_a > 0 && at_b > 0) return {1, 0};
        if (at_a <= 0 && at_b <= 0) continue;
        const Real t = at_a / (at_a - at_b);
        if (at_a > 0 && t > s.from) s.from = t;
        if (at_b > 0 && t < s.to) s.to = t;
    }
    return s;
}

void clip_to_prism(Polygon& polygon, const Triangle& triangle, Vec3 direction, Real slack)
{
    for (int k = 0; k < 3 && polygon.count > 0; ++k) {
        const Vec3 m = outward(triangle, k, direction);
        clip(polygon, m, dot(m, triangle.v[k]), slack);
    }
}

}  // namespace epode
