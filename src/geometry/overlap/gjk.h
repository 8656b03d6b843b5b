// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Distance of two convex solids that do not overlap (Gilbert, Johnson, Keerthi 1988): the point of
// C = { x - y : x in a, y in b } nearest to the origin, sought on simplices of support points.
// The nearest point on a simplex is found by trying its faces from small to large (Ericson 2004), in place of
// Johnson's recursion, whose determinants cancel badly on thin simplices.
// Overlapping solids end with distance 0; their depth is epa.h's business.
#pragma once

#include "geometry/convex_view.h"

namespace epode {

struct Distance {
    Real distance = 0;  // between the cores: radii are not subtracted; 0: they overlap or touch
    Vec3 on_a, on_b;    // closest points of the cores, meaningful when distance > 0
    Vec3 normal;        // unit, from b to a, likewise
};

// How the last digits are found where a rim is nearest: by the same steps, or by Newton's method (rim_distance.h),
// which takes a third of the work and gives the same distance to the tolerance, not the same bits.
enum class LastDigits { kBySteps, kByNewton };

// Stops early with a lower bound once the distance is known to exceed `limit`, and with points so far apart
// as they may be by `tolerance`, a part of the distance.
Distance gjk_distance(const ConvexView& a, const ConvexView& b, Real limit = kInf,
                      Real tolerance = 4 * kEpsilon, LastDigits last = LastDigits::kBySteps);

}  // namespace epode
