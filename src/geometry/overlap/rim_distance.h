// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The distance of a cylinder and a box, capsule, sphere or cylinder, from a direction that is nearly right. GJK walks
// round a rim in steps that shrink by a constant factor; Newton's method doubles the digits. Along a unit vector n from b
// to a the two are apart by
//   F(n) = n . (A - B) - h_a(n) - h_b(n),   h(n) = sum half_i |n . e_i| + r |n - (n . e) e|
// with A, B the centres, e_i the axes of a box, or the one of a cylinder or capsule, and r the radius of a rim. F is
// largest, and then the distance, where its gradient, the difference v of the nearest points, is along n. A feature that
// extends along e_i (an edge, a side line, a face) holds n upright to e_i, since |n . e_i| has a kink there; the end of a
// cylinder holds n on its axis. In what is left of the tangent plane the Hessian of F is
//   -sum (r / rho) t t^T,   t = e x q / rho, q the part of n across e, rho = |q|
// and a step solves (F + sum (r / rho) t t^T) dn = v. F of any n is a lower bound, so the answer is checked, not
// believed. Rejected: Nesterov's steps in GJK (Montaut et al. 2022), still tens of supports for the last digits.
#pragma once

#include "geometry/overlap/gjk.h"

namespace epode {

// Two points that a search has found near the nearest ones, of the cores.
struct NearPoints {
    Vec3 on_a, on_b;
};

// Whether the two are such shapes.
bool has_rim_distance(const ConvexView& a, const ConvexView& b);

// True if `out` is the distance to the tolerance, as of gjk_distance(). `n`: a direction near the right one, from b to
// a. `near`: points of both whose convex hulls are near the nearest points.
bool rim_distance(const ConvexView& a, const ConvexView& b, Vec3 n, std::span<const NearPoints> near,
                  Real tolerance, Distance& out);

}  // namespace epode
