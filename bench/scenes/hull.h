// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Small convex hulls by brute force: a triangle of points is a face when all others lie behind it, O(n^4),
// which a scene's twenty points can afford and which leaves nothing to doubt. Points on a sphere are in
// general position but for the rounding, so that faces are triangles.
#pragma once

#include "bench/scenes/scene_data.h"

namespace epode::bench {

// The points moved so that the hull's centre of mass is the origin; those inside are left out.
ShapeData make_hull(std::vector<Vec> points);

struct Solid {
    double volume = 0;
    Vec centre;
    Vec second;  // integrals of x^2, y^2, z^2 about the origin
};
Solid integrate(const ShapeData& hull);

// n points spread over a sphere on a spiral with the golden angle.
std::vector<Vec> spiral_points(int n, double radius);
// n points on a sphere, at random.
std::vector<Vec> random_points(int n, double radius, scenes::Lcg& random);

}  // namespace epode::bench
