// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A cylinder against an edge of a triangle: of the directions in which the triangle shows that edge, from its
// normal N over the edge's outward side O to -N, those of least overlap. Along n = x N + y O it is
//   g = n . w + h |n . d| + r sqrt(n^2 - (n . d)^2)
// with w from the cylinder's centre to the edge, d its axis, h half its length. Three numbers of each of w
// and d, no support points: g is sampled at eight places, and where it turns the root of its slope is found.
// As g is the extent of a convex set, g + g'' >= 0: where g is small it is all but convex, which bounds it
// from below between two samples, so that most of them need no root. What a search by expanding polytopes
// finds besides, faces and corners, have directions that are known (triangle_solid.cpp).
#pragma once

#include "geometry/triangle.h"

namespace epode {

struct RimMinimum {
    Vec3 normal;
    Real overlap = 0;
};

// g of one edge.
struct RimArc {
    RimArc(const Cylinder& cylinder, const Pose& pose, const Triangle& triangle, int edge);
    Vec3 normal, outward;       // N, O
    Real wn, wo, dn, dd, h, r;  // w and d along N and O
};

// Local minima below `worth`; how many, at most kMostRimMinima.
inline constexpr int kMostRimMinima = 4;
int rim_minima(const RimArc& arc, Real worth, RimMinimum* out);

// Whether there may be one of them between the triangle's own normal and the neighbour's over the edge, which
// falls away there: g falls at the one and rises at the other.
bool rim_turns_before(const RimArc& arc, Vec3 neighbour_normal);

}  // namespace epode
