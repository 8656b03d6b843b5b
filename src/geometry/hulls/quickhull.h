// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The convex hull of points in space: quickhull (Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for
// convex hulls", ACM TOMS 22(4), 1996), farthest point first. Two things are ours:
//   exact signs   points are rounded to a grid of 2^-40 of their extent, and the side of a plane on which a
//                 point lies is an integer of at most 126 bits. The growing solid is therefore at every
//                 moment the true hull of the points chosen so far: no thick facets, no torn horizons.
//   merging last  when the hull stands, facets that lie in one plane to `flat` times the extent become one
//                 face, and what then is no corner of three faces is no corner.
// Points are put in order of their coordinates first, so that the result does not depend on theirs. Rejected:
// merging while the hull grows (as in the paper): its repairs depend on rounding and on the order.
#pragma once

#include "base/array.h"
#include "math/vec.h"

namespace epode {

enum class HullFault { kNone, kPoint, kLine, kPlane, kMemory };

struct Hull {
    // Indices into the points given, in rising order.
    Array<int> vertices;
    // Faces one after the other: how many corners, then the corners as places in `vertices`,
    // counter-clockwise from outside.
    Array<int> faces;
    Array<Vec3> normals;  // of the faces, as the grid has them
};

// The hull of at least one point, usable numbers. Points within `flat` of the extent (the largest side of
// their bounding box) of one plane are refused as kPlane. `max_vertices`: grow to this many vertices and stop
// there,
// with the farthest points taken first; at least 4. Every point lies within 2 * flat of the extent of every
// face's plane, but for those that `max_vertices` left out.
HullFault convex_hull(std::span<const Vec3> points, Real flat, int max_vertices, Hull& out);

}  // namespace epode
