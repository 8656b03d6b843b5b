// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Signed distance of two convex solids, and where it is attained. With C = { x - y : x in a, y in b }:
// outside C the distance of the origin from C (GJK), inside it minus the least depth (least_overlap in
// geometry/overlap/epa.h), radii subtracted from either. n points from b into a, and on_a - on_b = distance * n.
//   apart        the closest points, moved along n by the radii
//   overlapping  n is the way of least depth; the points are those that are closest when a has been moved
//                along n until a little gap has opened, moved back. (The support points along n alone would
//                lie anywhere on flush faces, on one of them beyond the other.)
// The alternative for the second case, the weights of the last face of the polytope, is exact only where the
// polytope was, not where its answer has been polished.
#pragma once

#include "geometry/overlap/gjk.h"

namespace epode {

struct Separation {
    Real distance = kInf;  // negative: depth; kInf: farther than was asked
    Vec3 on_a, on_b;
    Vec3 normal;  // unit, from b into a
    int side_a = -1, side_b = -1;

    // Of equal ones that of the lower triangles, so that the order of trials does not matter.
    bool before(const Separation& o) const
    {
        if (distance != o.distance) return distance < o.distance;
        return side_a != o.side_a ? side_a < o.side_a : side_b < o.side_b;
    }
    Separation turned() const { return {distance, on_b, on_a, -normal, side_b, side_a}; }
};

// Of solids that are farther from each other than `limit`, only that.
Separation separation(const ConvexView& a, const ConvexView& b, Real limit,
                      LastDigits last = LastDigits::kBySteps);

// Of a solid and the half-space.
Separation separation(const ConvexView& a, const Plane& b);

}  // namespace epode
