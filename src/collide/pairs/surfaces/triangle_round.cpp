// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A round core s of radius r against a triangle of a mesh, of which only the front has contacts:
//   over the triangle   ends of the part of s whose foot lies in it, depth r - height; where s pierces it,
//                       the end that is through, if no crest is nearer (triangle_solid.cpp)
//   at a crest          nearest points p, q of s and the edge, along p - q
// For a ball whose contacts the program reads, the place is on the mesh as in ODE, and where its foot is on
// an edge or a corner, each triangle that lies there in one plane has a contact.
// Ends that a seam has cut are left to the neighbour.
#include "collide/pairs/surfaces/mesh_facet.h"
#include "collide/pairs/surfaces/round_edges.h"

namespace epode {

namespace {

// False when the contacts are already all there are.
bool over(const RoundSolid& s, const PastEdges& past, const MeshFacet& f, MeshPair& m)
{
    const CutPart part = past.part_over(m.slack);
    if (part.t.empty()) return true;
    const Vec3 p = s.a + part.t.from * (s.b - s.a), q = s.a + part.t.to * (s.b - s.a);
    const Real at_p = f.height(p), at_q = f.height(q);
    if (at_p < -m.slack && at_q < -m.slack) return true;  // under it, not through it
    const bool pierces = at_p < -m.slack || at_q < -m.slack;
    if (pierces && f.has_crest() && add_crest_if_least(f, m)) return false;
    const auto add = [&](Vec3 x, Real height, bool cut) {
        const bool through = height < -m.slack;
        const Real depth = s.r - height;
        if (depth >= -m.slack && (!cut || through))
            m.out.add(x - s.r * f.n, f.n, depth > 0 ? depth : 0, f.index);
    };
    add(p, at_p, part.at_from >= 0 && m.seam(f, part.at_from));
    add(q, at_q, part.at_to >= 0 && m.seam(f, part.at_to));
    return true;
}

// A border that is hardly below the round: the surface goes on, for all we know (kLip).
bool over_lip(const RoundSolid& s, const MeshFacet& f, Vec3 p, Vec3 q, MeshPair& m)
{
    const Real height = f.height(p);
    if (!(s.r - height < kLip * s.r)) return false;
    const Real side2 = length2(p - q) - height * height, rise2 = s.r * s.r - side2;
    if (rise2 > height * height) m.out.add_at_border(q, f.n, std::sqrt(rise2) - height, f.index);
    return true;
}

void round_at_crest(const RoundSolid& s, const MeshFacet& f, int edge, Vec3 p, Vec3 q, MeshPair& m)
{
    Vec3 n = p - q;
    const Real reach = s.r + m.slack, distance2 = length2(n);
    if (distance2 > reach * reach || !normalize(n)) return;
    const Real distance = std::sqrt(distance2), near2 = m.slack * m.slack;
    const int next = (edge + 1) % 3;
    Crest crest;
    if (length2(q - f.v[edge]) <= near2)
        crest = crest_at_corner(m.mesh, f, edge, n, m.refused);
    else if (length2(q - f.v[next]) <= near2)
        crest = crest_at_corner(m.mesh, f, next, n, m.refused);
    else
        crest = crest_at_edge(f, edge, n);
    if (!crest.stands || (crest.border && over_lip(s, f, p, q, m))) return;
    const Vec3 at = m.as_ode ? q : p - s.r * n;
    const Real depth = s.r > distance ? s.r - distance : 0;
    crest.border ? m.out.add_at_border(at, n, depth, f.index) : m.out.add(at, n, depth, f.index);
}

// A ball over a triangle.
void over_inside(Vec3 centre, Real radius, Vec3 n, Real height, int triangle, MeshPair& m)
{
    const ContactPoint point{centre - (m.as_ode ? height : radius) * n, n,
                             radius > height ? radius - height : 0, -1, triangle};
    m.as_ode ? m.out.add_apart(point) : m.out.add(point);
}

}  // namespace

void round_on(const RoundSolid& s, const MeshFacet& f, MeshPair& m)
{
    const Real at_a = f.height(s.a), at_b = f.height(s.b);
    const Real top = s.r + m.slack;
    if ((at_a > top && at_b > top) || at_a + at_b < -2 * m.slack) return;
    const PastEdges past(s, f);
    const Real low = at_a < at_b ? at_a : at_b, above = low > 0 ? low : Real(0), aside = past.least();
    if (aside * aside + above * above > top * top) return;
    if (!over(s, past, f, m)) return;
    const Real inside = -kLevel * top;  // farther in, every way from the edge leads over the triangle
    for (int k = 0; k < 3; ++k) {
        if (!f.sharp[k] && !f.sharp[(k + 1) % 3]) continue;
        if (past.a[k] < inside && past.b[k] < inside) continue;
        meet_edge(s, f.v[k], f.edge(k), [&](Vec3 p, Vec3 q) { round_at_crest(s, f, k, p, q, m); });
    }
}

void ball_on(Vec3 centre, Real radius, int triangle, MeshPair& m)
{
    const TriangleMesh& mesh = m.mesh;
    const Vec3 n = mesh.normal(triangle);
    const Vec3 v[3] = {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
    const Real height = dot(n, centre) - dot(n, v[0]), top = radius + m.slack;
    if (height > top || height < -m.slack) return;
    const Vec3 e[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    Real beyond[3], aside = 0;
    for (int k = 0; k < 3; ++k) {
        beyond[k] = dot(cross(e[k], n), centre - v[k]) / length(e[k]);
        aside = beyond[k] > aside ? beyond[k] : aside;
    }
    const Real above = height > 0 ? height : Real(0);
    if (aside * aside + above * above > top * top) return;
    if (aside <= m.slack) over_inside(centre, radius, n, height, triangle, m);
    const MeshRims rims = rims_of(mesh, triangle, m.refused);
    const Real inside = -kLevel * top;
    MeshFacet f;
    for (int k = 0; k < 3; ++k) {
        if (beyond[k] < inside || !(rims.sharp[k] || rims.sharp[k == 2 ? 0 : k + 1])) continue;
        const Vec3 q = v[k] + closest_on_segment(v[k], v[k == 2 ? 0 : k + 1], centre) * e[k];
        if (length2(centre - q) > top * top) continue;
        if (f.index < 0) f = m.facet(triangle);
        round_at_crest({centre, centre, radius}, f, k, centre, q, m);
    }
}

}  // namespace epode
