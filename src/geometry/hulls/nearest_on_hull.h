// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The point of a polyhedron nearest to a point p outside, or the face nearest to one inside. The face whose
// plane p is farthest beyond holds the nearest point if p projects into it: no other plane is nearer to the
// solid. Else an edge does that belongs to a face that p is beyond. Exact, where the general distance
// (gjk.h) approaches it.
#pragma once

#include "geometry/hulls/polyhedron.h"

namespace epode {

struct NearestOnHull {
    Vec3 point;         // of the surface
    Vec3 normal;        // unit, from there to p, outward
    Real distance = 0;  // negative inside
    bool on_face = false;
};

// In the frame of the solid's vertices. False when p is farther from the solid than `limit`.
bool nearest_on_hull(const Polyhedron& solid, Vec3 p, Real limit, NearestOnHull& out);

}  // namespace epode
