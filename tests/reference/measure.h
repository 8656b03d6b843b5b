// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How far two solids overlap or are apart, by means as plain as can be.
//   overlap_along   what must be moved along a direction to part them: h(n) of any n is an upper bound of the
//                   depth, and a proof that they are apart when it is negative
//   least_overlap   the least of h over 20,000 directions evenly spread on the sphere, each of the best few
//                   then bettered by trying circles of neighbours, ever smaller ones
//   distance        the point of the difference nearest to the origin, among the support points so far: of
//                   all their subsets of at most four, solved as linear equations (Wolfe 1976)
#pragma once

#include "solid.h"

namespace epode::reference {

struct Overlap {
    double depth;
    Point normal;  // from the second to the first
};

// The second may be a plane: then there is one direction, its normal.
double overlap_along(const Solid& a, const Solid& b, const Point& normal);
Overlap least_overlap(const Solid& a, const Solid& b, int directions);

// Zero when they touch or overlap; `way`: from the second to the first.
double distance(const Solid& a, const Solid& b, Point& way);

}  // namespace epode::reference
