// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// When do two geoms that move and turn first meet within a step, so deep that it must not go on? By
// conservative advancement with turning (Mirtich 1996), on the signed distance s of separation.h: along the
// normal n between the two no point comes nearer faster than
//     c = -n . d_a + |n x w_a| r_a  +  n . d_b + |n x w_b| r_b        (r: reach from the centre of turning)
// and s, depth included, falls no faster. So s stays above -depth for (s + depth) / c at least, again and
// again; nothing is passed, however thin.
//   what counts  depth beyond `allowed`, a share of the thickness of what moves: what only grazes, slides
//                or rests is left to contacts. Who counts is stopped where it is `hair` deep, so that the
//                next collision finds the contact.
//   at contact   what is a hair deep at the beginning is held by the contacts that the program has made:
//                it may go deeper by a part of `allowed`, and stops a hair deeper than it was. If there are
//                none the program wants none.
//   surfaces     triangle by triangle along the way, in pieces; from behind where the pair's contacts push
//   so.
// Rejected: shrinking the moving solid to a core and casting that. Its edges would be passed.
#pragma once

#include "query/motion.h"
#include "query/query_shape.h"

namespace epode {

struct Mover {
    QueryShape shape;  // its pose is that at the beginning
    Motion motion;
};

struct ImpactRule {
    Real allowed, hair;
    bool held;  // a contact acts between the two
};

// 0 ... most; kInf: they do not meet by then. `a` is a solid or a mesh, and neither is a ray.
Real time_of_impact(const Mover& a, const Mover& b, const ImpactRule& rule, Real max_time);

// Radius of a ball inside, of a mesh half of what it is thick; never 0. Of what has no other side: kInf.
Real half_thickness(const QueryShape& shape);

}  // namespace epode
