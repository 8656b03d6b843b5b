// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A round core s of radius r against a facet:
//   over the facet        ends of the part of s whose foot lies in the facet, depth r - height
//   at an edge            nearest points p, q of s and the edge, along p - q
//   core under the facet  ends of the part of s in the column, depth r + distance
// At holes the walls are facets, too, and their upright edges are edges.
#include "collide/pairs/surfaces/facet.h"
#include "collide/pairs/surfaces/round_edges.h"

namespace epode {

namespace {

// Of the radius: farther in from an edge, every way from the edge leads over the facet.
constexpr Real kInside = Real(1e-3);

// The ends of a part of s, of which only what is over the face, or under it.
void push_ends(const RoundSolid& s, const Triangle& f, bool over, Stretch part, TerrainPair& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    const bool keep_a = over ? at_a >= 0 : at_a <= 0, keep_b = over ? at_b >= 0 : at_b <= 0;
    if (keep_a != keep_b) {
        const Real t = at_a / (at_a - at_b);
        if (!keep_a && t > part.from) part.from = t;
        if (!keep_b && t < part.to) part.to = t;
    }
    if (part.empty()) return;
    for (const Real t : {part.from, part.to}) {
        const Vec3 p = s.a + t * (s.b - s.a);
        const Real depth = s.r - f.height(p);
        if (depth >= 0) m.out.add(p - s.r * f.n, f.n, depth);
        if (s.a == s.b) return;
    }
}

// `column`: the direction to the face from behind it; `under`: whether what is behind the face has contacts.
void over_and_under(const RoundSolid& s, const Triangle& f, const PastEdges& past, Vec3 column, bool under,
                    TerrainPair& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    if (at_a >= 0 || at_b >= 0) push_ends(s, f, true, past.part_over(m.slack).t, m);
    if (under && (at_a <= 0 || at_b <= 0))
        push_ends(s, f, false, within_prism(f, column, s.a, s.b, m.slack), m);
}

// `rim`: of a hole, over a wall.
void round_at_edge(const RoundSolid& s, const Facet& f, bool rim, Vec3 p, Vec3 q, TerrainPair& m)
{
    Vec3 n = p - q;
    const Real distance = length(n);
    if (distance > s.r || !(distance > m.slack) || !normalize(n)) return;
    if (rim ? n.y < 0 : n.y < kSteepest || dot(n, f.n) < 0) return;
    if (!m.terrain.crests(f, n)) return;
    m.add_crest(f, p - s.r * n, n, s.r - distance);
}

// The edge between two walls that meet at corner k of the facet; `one` and `other` point into the hole.
void round_at_upright(const RoundSolid& s, const Facet& f, int k, Vec3 one, Vec3 other, TerrainPair& m)
{
    const Vec3 down{0, -m.terrain.thickness(), 0};
    meet_edge(s, f.v[k], down, [&](Vec3 p, Vec3 q) {
        Vec3 n = p - q;
        const Real distance = length(n);
        if (q.y >= f.v[k].y || distance > s.r || !(distance > m.slack) || !normalize(n)) return;
        if (n.y < -kSteepest || dot(n, one) < 0 || dot(n, other) < 0) return;
        m.out.add(p - s.r * n, n, s.r - distance);
    });
}

void on_walls(const RoundSolid& s, const Facet& f, TerrainPair& m)
{
    for (const int k : {0, 2}) {
        Triangle wall[2];
        if (!m.terrain.hole_beyond(f, k) || !m.terrain.wall_below(f, k, wall)) continue;
        for (const Triangle& t : wall)
            over_and_under(s, t, PastEdges(s, t), t.n, m.walls->gives_contacts(f, k), m);
        // Either end of the edge may be a corner of the terrain; k + 1 of edge 2 and k of edge 0 are one.
        const int step = f.upper ? 1 : -1;
        const Vec3 along = k == 0 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
        for (const Real side : {Real(-1), Real(1)}) {
            const bool here = side * Real(step) > 0;  // towards the facet's own corner v[0]
            if (here && k == 2) continue;             // done by edge 0
            const int i = f.i + (k == 2 ? int(side) : 0), j = f.j + (k == 0 ? int(side) : 0);
            if (!m.terrain.hole(i, j)) continue;
            const int corner = here ? 0 : k == 0 ? 1 : 2;
            if (!here && f.upper) continue;  // the lower facet's edge ends there, too
            round_at_upright(s, f, corner, f.out(k), side * along, m);
        }
    }
}

}  // namespace

void weigh_round(const RoundSolid& s, const Facet& f, TerrainPair& m)
{
    const Stretch part = within_prism(f, kUp, s.a, s.b, m.slack);
    if (part.empty()) return;
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    const auto height = [&](Real t) { return at_a + t * (at_b - at_a); };
    const Real lowest = height(part.from) < height(part.to) ? height(part.from) : height(part.to);
    if (!(lowest < 0)) return;
    for (const int k : {0, 2}) {
        if (!m.terrain.hole_beyond(f, k)) continue;
        const Vec3 out = f.out(k);
        const Real a = dot(out, s.a) - f.out_limit(k), b = dot(out, s.b) - f.out_limit(k);
        const Real inner = a < b ? a : b, outer = a < b ? b : a;
        if (outer + s.r > m.slack && (m.walls->sunk(f) || inner > lowest)) m.walls->push(f, k);
    }
}

void round_on(const RoundSolid& s, const Facet& f, TerrainPair& m)
{
    if (m.walls) on_walls(s, f, m);
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    if (at_a > s.r && at_b > s.r) return;
    const PastEdges past(s, f);
    if (!m.walls && at_a >= 0 && at_b >= 0) {
        const Real above = at_a < at_b ? at_a : at_b, aside = past.least(), reach = s.r + m.slack;
        if (aside * aside + above * above > reach * reach) return;
    }
    over_and_under(s, f, past, kUp, !m.walls || !(m.walls->sunk(f) || m.walls->behind(f)), m);
    const bool below = at_a < 0 && at_b < 0;
    const Real inside = -kInside * s.r;
    for (int k = 0; k < 3; ++k) {
        const bool rim = m.walls && m.terrain.hole_beyond(f, k);
        if (!rim && (below || (past.a[k] < inside && past.b[k] < inside))) continue;
        meet_edge(s, f.v[k], f.edge(k), [&](Vec3 p, Vec3 q) { round_at_edge(s, f, rim, p, q, m); });
    }
}

}  // namespace epode
