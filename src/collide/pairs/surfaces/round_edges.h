// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A round core s, a segment or a point, and the edges of one triangle: of a height field or of a mesh.
#pragma once

#include "collide/pairs/surfaces/on_surface.h"
#include "geometry/closest.h"
#include "geometry/triangle.h"

namespace epode {

// A part of s, and the edges that cut its ends; -1: none.
struct CutPart {
    Stretch t;
    int at_from = -1, at_to = -1;
};

// How far the ends of s are beyond the edges, seen along the triangle's normal.
struct PastEdges {
    Real a[3], b[3];

    PastEdges(const RoundSolid& s, const Triangle& f)
    {
        for (int k = 0; k < 3; ++k) {
            const Vec3 e = f.edge(k), out = cross(e, f.n);
            const Real per = 1 / length(e);
            a[k] = per * dot(out, s.a - f.v[k]), b[k] = per * dot(out, s.b - f.v[k]);
        }
    }

    // The part whose foot is in the triangle or outside it by at most the slack.
    CutPart part_over(Real slack) const
    {
        CutPart part;
        for (int k = 0; k < 3; ++k) {
            const Real at_a = a[k] - slack, at_b = b[k] - slack;
            if (at_a > 0 && at_b > 0) return {{1, 0}};
            if (at_a <= 0 && at_b <= 0) continue;
            const Real t = at_a / (at_a - at_b);
            if (at_a > 0 && t > part.t.from) part.t.from = t, part.at_from = k;
            if (at_b > 0 && t < part.t.to) part.t.to = t, part.at_to = k;
        }
        return part;
    }

    // Of all of s beyond one of them.
    Real least() const
    {
        Real largest = 0;
        for (int k = 0; k < 3; ++k) {
            const Real low = a[k] < b[k] ? a[k] : b[k];
            largest = low > largest ? low : largest;
        }
        return largest;
    }
};

// meet(p, q) for the nearest points of the core and an edge from v along e; of two that lie side by side for
// both ends of the common stretch.
template <typename Meet>
void meet_edge(const RoundSolid& s, Vec3 v, Vec3 e, const Meet& meet)
{
    const Vec3 axis = s.b - s.a;
    if (axis == Vec3{}) return meet(s.a, v + closest_on_segment(v, v + e, s.a) * e);
    Vec3 p, q;
    closest_segment_points(s.a, s.b, v, v + e, p, q);
    meet(p, q);
    if (!(length2(axis) > 0) || length2(cross(axis, e)) > Real(1e-2) * length2(axis) * length2(e)) return;
    for (const Vec3 end : {s.a, s.b}) meet(end, v + closest_on_segment(v, v + e, end) * e);
    for (const Vec3 end : {v, v + e}) meet(s.a + closest_on_segment(s.a, s.b, end) * axis, end);
}

}  // namespace epode
