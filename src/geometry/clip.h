// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex polygons of a fixed capacity, and cutting them by half-spaces (Sutherland and Hodgman 1974). The
// points need not be exactly coplanar: cutting only interpolates along edges. A polygon of two points is a
// segment, of one a point; both are cut correctly.
#pragma once

#include "math/vec.h"

namespace epode {

struct Polygon {
    static constexpr int kMax = 64;
    union {
        Vec3 points[kMax];  // in a union: left unwritten until added
    };
    int count = 0;
    Vec3 normal;  // unit, of the face whose corners these are; zero: not said
    Polygon() {}
    void add(Vec3 p)
    {
        if (count < kMax) points[count++] = p;
    }
};

// Keeps the part with normal . x <= limit. Points outside by no more than `slack` stay as they are: flush
// faces would otherwise sprout pairs of nearly equal points.
void clip(Polygon& polygon, Vec3 normal, Real limit, Real slack);
void clip(Polygon& polygon, int axis, Real sign, Real limit, Real slack);  // the normal is +-axis

// Cuts by the sides of `reference`, a convex polygon that runs counter-clockwise about `normal`.
void clip_to_prism(Polygon& polygon, const Polygon& reference, Vec3 normal, Real slack);

}  // namespace epode
