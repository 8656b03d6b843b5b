// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Signed distance of any two geoms. Four sorts of things meet: solids (rays among them, as segments), the
// half-spaces of planes, and surfaces, which are meshes and height fields.
//   solid, solid      separation.h
//   with a plane      the farthest point against its normal, of a surface the lowest vertex
//   with a surface    the least over its triangles, each taken as a flat solid: so within a surface, minus
//                     the depth of the deepest triangle. Triangles are asked of the tree in boxes that grow
//                     until the best is nearer than what has not been looked at.
//   with a field      the ground under it is solid: where dCollide has contacts, minus the deepest of these
//   two planes        finite only when they look at each other; else they overlap without end
//   spaces            the least over their members
// Rejected for surfaces: a walk of two trees at once, node against node; the trees of meshes have no boxes to
// measure distances by, and growing boxes visit less than twice of what they must.
#pragma once

#include "collide/geom.h"
#include "query/separation.h"

namespace epode {

struct GeomSeparation : Separation {
    Geom* a = nullptr;  // null: nothing within the limit
    Geom* b = nullptr;
};

// Nothing when they are farther apart than `limit`, and for classes of the program. No spaces.
GeomSeparation separation(Geom& a, Geom& b, Real limit);

// Do they touch or overlap? For classes of the program, and pairs that the program has overridden, as
// dCollide says.
bool overlapping(Geom& a, Geom& b);

}  // namespace epode
