// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Penetration of two convex solids: the least distance by which one must be moved to part them.
// With C = { y - x : x in a, y in b } and its support function h(n) = max over C of n . c, moving a by h(n) n
// parts the solids for every unit n, so the depth is the least h(n); a negative h(n) proves that they are
// apart already.
//   expand:        grows a polytope inside C from four support points, always at the face plane nearest to
//                  (or farthest beyond) the origin: van den Bergen's expanding polytope (2001), but with
//                  signed plane distances, so that it needs no enclosing simplex from GJK and also answers
//                  "apart".
//   least_overlap: the same answer to rounding for the primitives: directions that can be least (faces,
//                  products of edges) are tried exactly, the others are polished by root finding on the slope
//                  of h.
// Rejected: MPR; its normal is only roughly the least one and jumps from step to step.
#pragma once

#include "geometry/convex_view.h"

namespace epode {

struct Overlap {
    Vec3 normal{1, 0, 0};  // from b into a
    Real depth = kInf;     // least h found, radii not counted; negative: apart along the normal
    bool apart() const { return depth < 0; }
};

// h(normal), and the point of C that attains it.
struct Extent {
    Real h;
    Vec3 point;
};
inline Extent extent(const ConvexView& a, const ConvexView& b, Vec3 normal)
{
    const Vec3 c = b.support(normal) - a.support(-normal);
    return {dot(normal, c), c};
}

// Improves `best` until it is within `tolerance` of the least, or below `enough` (then it may stop early).
void expand(const ConvexView& a, const ConvexView& b, Real tolerance, Real enough, Overlap& best);

// Improves `best` by the face of the polyhedron v that looks most along the guess, tried exactly: flush faces
// answer with the face's own normal and not with that of three rounded points. v is a (`sense` -1) or b (1).
void offer_face(const ConvexView& v, Real sense, Vec3 guess, const ConvexView& a, const ConvexView& b,
                Overlap& best);

// Radii are not counted; `enough` = -(sum of radii) stops early only at proofs that matter.
Overlap least_overlap(const ConvexView& a, const ConvexView& b);

}  // namespace epode
