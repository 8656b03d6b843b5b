// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The least overlap of two convex solids of which one is known by its support function alone, to rounding.
// C and h(n) are those of epa.h. Face normals that the views name are tried exactly; else the expanding
// polytope finds the valley of h, and a fixed point its floor: moved apart along the normal n so far that a
// gap g is left, the two have their nearest points along n', and n' is the next n. With d the depth and R the
// radius of curvature of C where it is touched, a deviation from the least normal shrinks by (d + g) / (R +
// g) each time, and R > d where h is least: faces (R infinite) are met at once, edges of C (R = 0) are no
// minima. It needs no derivatives, so corners, creases and rims need no cases of their own.
#pragma once

#include "geometry/overlap/epa.h"

namespace epode {

// Radii are not counted; may stop at an overlap below `enough`, which proves the solids apart.
Overlap curved_overlap(const ConvexView& a, const ConvexView& b, Real enough);

}  // namespace epode
