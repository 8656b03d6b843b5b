// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Shape casts: a convex solid moves along a straight way without turning; when does it first meet another
// geom? Against a convex solid by conservative advancement (Mirtich 1996): at distance d with normal n it may
// move d / (-n . u) along u before the plane across n between the two is reached, and no less; where u does
// not approach along n, convex solids never meet. So the solid never passes what it meets, however thin.
// Against a surface each triangle that lies on the way is such a solid, the way taken piece by piece so that
// little is looked at; a height field is ground where the solid begins.
//   at the beginning  what overlaps is met at once, at distance 0; what only touches is met if the way leads
//                     into it, so that a solid may slide along what it lies on.
// The alternative, GJK against the swept solid (ray casting on the difference; van den Bergen 2004), saves
// iterations but ends with a normal that depends on them.
#pragma once

#include "collide/geom.h"
#include "query/separation.h"

namespace epode {

struct Way {
    Vec3 along;  // unit
    Real length = 0;
};

struct SweepHit {
    Real distance = kInf;  // on the way; kInf: not met
    Vec3 pos, normal;      // normal: from the other into the solid
    int side = -1;
    Geom* named = nullptr;

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
