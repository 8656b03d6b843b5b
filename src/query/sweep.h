// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shape casts: a convex solid moves along a straight path without rotation; when does it first hit another
// geom? Against a convex solid by conservative advancement (Mirtich 1996): at distance d with normal n it can
// move d / (-n . u) along u before it reaches the plane across n between the two. If u does not approach
// along n, the two convex solids never meet. So the solid never passes through anything, however thin. On a
// surface every triangle on the path is such a solid; the path is taken in pieces so that few triangles are
// examined. A height field is solid below its surface at the start of the path.
//   at the start  an overlapping geom is hit at once, at distance 0. A touching geom is hit only if the path
//                 leads into it, so that a solid can slide along what it rests on.
// The alternative, GJK against the swept solid (ray casting on the difference; van den Bergen 2004), saves
// iterations but ends with a normal that depends on them.
#pragma once

#include "collide/geom.h"
#include "query/separation.h"

namespace epode {

struct Way {
    Vec3 along;  // unit
    Real length = 0;
    bool skips_overlaps = false;  // solids and triangles that overlap at the start are not met
};

struct SweepHit {
    Real distance = kInf;  // on the way; kInf: not met
    Vec3 pos, normal;      // normal: from the other into the solid
    int side = -1;
    Geom* named = nullptr;
    Real depth = 0;          // of an overlap at the start
    bool cut_short = false;  // parts of the other were not looked at (effort.h)

    bool before(const SweepHit& o) const
    {
        return distance != o.distance ? distance < o.distance : side < o.side;
    }
};

// Not met beyond `limit`.
SweepHit sweep(Geom& solid, const Way& way, Geom& other, Real limit);

// Can it be moved so? (Through transforms.)
bool is_solid(Geom& geom);

}  // namespace epode
