// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Closest points between simple things, as pure numbers.
//   segment-segment: minimise |a1 + s u - b1 - t v|^2 over the unit square (Lumelsky 1985; the order of
//                    clamping follows from convexity). Parallel lines: a solution with an end point is
//                    chosen.
//   segment-box:     the squared distance of a point moving along the segment is a convex, piecewise
//                    quadratic function of t; its pieces end where a coordinate crosses a face plane.
#pragma once

#include "geometry/shapes.h"

namespace epode {

void closest_segment_points(Vec3 a1, Vec3 a2, Vec3 b1, Vec3 b2, Vec3& p, Vec3& q);

// The parameter in [0, 1] of the point of a..b nearest to p.
Real closest_on_segment(Vec3 a, Vec3 b, Vec3 p);

// The parameter in [0, 1] of the point of a..b nearest to the box |x_i| <= half_i, everything in the box's
// frame; when a stretch is equally near, its middle.
Real closest_to_box(Vec3 a, Vec3 b, Vec3 half);

// a, whose length is known, at length one: one division where its square neither vanished nor overflowed,
// else the careful way.
inline Vec3 direction_of(Vec3 a, Real length, Vec3 fallback)
{
    constexpr Real kSmall = kSingle ? Real(1e-12) : Real(1e-100), kLarge = 1 / kSmall;
    if (length > kSmall && length < kLarge) [[likely]]
        return (1 / length) * a;
    return normalized_or(a, fallback);
}

// The nearest point of the box to p, in the box's frame.
constexpr Vec3 clamp_to_box(Vec3 p, Vec3 half) { return min(max(p, -half), half); }

}  // namespace epode
