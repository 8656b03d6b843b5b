// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The shortest way of a string from one point to another around a circle, a sphere or a cylinder without ends, as MJCF's
// spatial tendons have it. A string that goes round is straight to a point of the surface, lies on it, and is straight again.
//     sphere    in the plane of both points and the centre
//     cylinder  in the plane across its axis (z); on the surface and outside it climbs by the same share of its way
// A side, a point opposite to both ends as the centre sees it (in the angle between their reversed directions), makes the string go
// round by that way, whether or not the surface is in the straight one. A side within the surface keeps the string within: where
// the straight way passes outside, it bends at the point of the circle where that is shortest. From or to a point within the
// circle the way is straight.
#pragma once

#include "robots/geometry.h"

namespace epode::robots {

struct Wrap {
    bool touches = false;  // else straight
    Vec first, last;       // where it meets the surface and leaves it
    double length = 0;     // between the two
};

struct Surface {
    bool is_cylinder = false;
    double radius = 0;
    bool has_side = false;
    Vec side;
};

// All in the surface's own axes.
Wrap wrap_around(const Surface& surface, Vec from, Vec to);

}  // namespace epode::robots
