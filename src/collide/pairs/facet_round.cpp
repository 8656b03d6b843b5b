// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A round core s of radius r against a facet:
//   over the facet        ends of the part of s whose foot lies in the facet, depth r - height
//   beside an edge        nearest points p, q of s and the edge, along p - q
//   core under the facet  ends of the part of s in the column, depth r + distance
#include "collide/pairs/facet.h"
#include "geometry/closest.h"

namespace epode {

namespace {

void over_and_under(const RoundSolid& s, const Facet& f, Meeting& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    for (const bool over : {true, false}) {
        Stretch part = within_prism(f, over ? f.n : kUp, s.a, s.b, m.slack);
        // Only the ends on the right side of the plane.
        const auto keep = over ? at_a >= 0 : at_a <= 0, keep_b = over ? at_b >= 0 : at_b <= 0;
        if (!keep && !keep_b) continue;
        if (keep != keep_b) {
            const Real t = at_a / (at_a - at_b);
            if (!keep && t > part.from) part.from = t;
            if (!keep_b && t < part.to) part.to = t;
        }
        if (part.empty()) continue;
        for (const Real t : {part.from, part.to}) {
            const Vec3 p = s.a + t * (s.b - s.a);
            const Real depth = s.r - f.height(p);
            if (depth >= 0) m.out.add(p - s.r * f.n, f.n, depth);
        }
    }
}

void beside_edge(const RoundSolid& s, const Facet& f, Vec3 p, Vec3 q, Meeting& m)
{
    Vec3 n = p - q;
    const Real distance = length(n);
    if (distance > s.r || !(distance > m.slack) || !normalize(n)) return;
    if (n.y < kSteepest || dot(n, f.n) < 0 || !m.terrain.crests(f, n)) return;
    m.out.add(p - s.r * n, n, s.r - distance);
}

}  // namespace

void round_on(const RoundSolid& s, const Facet& f, Meeting& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    if (at_a > s.r && at_b > s.r) return;
    over_and_under(s, f, m);
    if (at_a < 0 && at_b < 0) return;
    const Vec3 axis = s.b - s.a;
    for (int k = 0; k < 3; ++k) {
        const Vec3 v = f.v[k], e = f.edge(k);
        Vec3 p, q;
        closest_segment_points(s.a, s.b, v, v + e, p, q);
        beside_edge(s, f, p, q, m);
        if (!(length2(axis) > 0) || length2(cross(axis, e)) > Real(1e-2) * length2(axis) * length2(e))
            continue;
        // Side by side: both ends of the common stretch.
        for (const Vec3 end : {s.a, s.b})
            beside_edge(s, f, end, v + closest_on_segment(v, v + e, end) * e, m);
        for (const Vec3 end : {v, v + e})
            beside_edge(s, f, s.a + closest_on_segment(s.a, s.b, end) * axis, end, m);
    }
}

}  // namespace epode
