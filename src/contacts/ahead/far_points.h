// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Points of a solid that do not touch yet while others do. A rod that lands on one end turns about it, and its other end comes down at
// twice the speed or more: looked for only where it touches, it is through a sheet of triangles before it is found. And a rod that was put down lying
// touches with that end alone which rounding has made the lower one. The pair functions of polyhedra find such corners themselves
// (ContactSink::margin); here they are, of all shapes on all surfaces, the lowest points of the solid's ends or corners, and the gap below
// each is the length of a ray along the normal.
#pragma once

#include "collide/collide.h"

namespace epode {

// One of a pair, where it is.
struct PlacedGeom {
    Geom& geom;
    const Pose& pose;
};

// Appends to the contacts of `a` and `b` those of points of solids among the two that are above the surface of the other by no more
// than `margin`, seen along the normal of the deepest contact: depth < 0, the place on the surface of `a`.
void add_far_points(const PlacedGeom& a, const PlacedGeom& b, Real margin, ContactArray& out);

}  // namespace epode
