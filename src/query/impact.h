// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The time at which two geoms that move and turn first penetrate too deep within a step. Conservative
// advancement with rotation (Mirtich 1996) on the signed distance s of separation.h: along the normal n no
// point of the two approaches faster than
//     c = -n . d_a + |n x w_a| r_a  +  n . d_b + |n x w_b| r_b        (r: reach from the centre of rotation)
// and s, depth included, decreases no faster. So s remains above -depth for at least (s + depth) / c, and
// this repeats. Nothing is passed, however thin.
//   what counts  a depth beyond `allowed`, which is a share of the mover's thickness. Grazing, sliding and
//                resting geoms are left to contacts. A mover that counts is stopped `hair` deep, so that the
//                next collision finds the contact.
//   at contact   two geoms that begin a hair deep are held by the program's contacts: they may go deeper by a
//                part of `allowed`, and stop a hair deeper than they were. Without contacts they pass,
//                because the program wants none.
//   surfaces     triangle by triangle along the path, in pieces; from behind only if the pair's contacts
//                push that way, too, and then none where the mover begins deeper than `allowed` and comes out.
// Rejected: casting a shrunken core of the moving solid. Its edges would be passed.
#pragma once

#include "query/effort.h"
#include "query/motion.h"
#include "query/query_shape.h"

namespace epode {

struct Mover {
    QueryShape shape;  // with the pose at the beginning
    Motion motion;
};

struct ImpactRule {
    Real allowed, hair;
    bool held;  // a contact joint acts between the two
};

struct ImpactTime {
    Real time;       // 0 ... most; kInf: they do not meet by then
    bool cut_short;  // parts of the two were not looked at (effort.h)
};
// `a` is a solid or a mesh, and neither is a ray.
ImpactTime time_of_impact(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time);

// The radius of an inscribed ball; for a mesh, half its thickness; never 0. kInf for a geom without a far
// side.
Real half_thickness(const QueryShape& shape);

}  // namespace epode
