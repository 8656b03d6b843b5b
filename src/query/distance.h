// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Signed distance of any two geoms. There are four kinds: solids (including rays, as segments), the
// half-spaces of planes, meshes and height fields; the last two are surfaces.
//   solid, solid      separation.h
//   with a plane      the farthest point against its normal; of a surface, the lowest vertex
//   with a surface    the least over its triangles, each taken as a flat solid. Inside a surface this is
//                     minus the depth of the deepest triangle. Triangles come from the tree in boxes that
//                     grow until the best is nearer than everything not yet examined, or as far as the
//                     effort goes.
//   with a field      the volume below it is solid: where dCollide has contacts, minus the largest depth
//   two planes        finite only when they face each other; otherwise they overlap without end
//   spaces            the least over their candidates
// Rejected for surfaces: walking two trees at once, node against node. The trees of meshes have no boxes to
// measure distances by, and growing boxes visit less than twice the necessary nodes.
#pragma once

#include "collide/geom.h"
#include "query/separation.h"

namespace epode {

struct GeomSeparation : Separation {
    Geom* a = nullptr;  // null: nothing within the limit
    Geom* b = nullptr;
    bool cut_short = false;  // parts of the two were not looked at (effort.h)
};

// Nothing when they are farther apart than `limit`, and for classes of the program. No spaces.
GeomSeparation separation(Geom& a, Geom& b, Real limit);

// Do they touch or overlap? For classes of the program, and pairs that the program has overridden, as
// dCollide says. `cut_short` becomes true if parts of the two were not looked at.
bool overlapping(Geom& a, Geom& b, bool& cut_short);

}  // namespace epode
