// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_facet.h. The edges around a corner are found by walking from neighbour to neighbour, both ways
// until the walk is closed or a border ends it.
#include "collide/pairs/surfaces/mesh_facet.h"

namespace epode {

namespace {

constexpr int kMostAround = 256;  // triangles at a corner

bool level_or_falls(Vec3 n, Vec3 along)
{
    const Real rise = dot(n, along);
    return rise <= 0 || rise * rise <= kLevel * kLevel * length2(along);
}

int corner_at(const TriangleMesh& mesh, int t, Vec3 v)
{
    const MeshCorners& corners = mesh.corners(t);
    for (int k = 0; k < 3; ++k)
        if (mesh.vertex(corners.at[k]) == v) return k;
    return -1;
}

// Walks around v from triangle t over its edge `over`.
bool falls_around(const TriangleMesh& mesh, const TriangleList* refused, int t, int over, Vec3 v, Vec3 n,
                  bool& border)
{
    const int first = t;
    for (int steps = 0; steps < kMostAround; ++steps) {
        const int next = mesh.neighbour(t, over);
        if (next == first) return true;
        if (next < 0 || (refused && refused->has(next))) {
            border = true;
            return true;
        }
        const int k = corner_at(mesh, next, v);
        if (k < 0) return true;  // beyond triangles without area: the corner ends here
        constexpr int kAfter[5] = {0, 1, 2, 0, 1};
        const int one = kAfter[k + 1], two = kAfter[k + 2];
        if (!level_or_falls(n, mesh.corner(next, one) - v) || !level_or_falls(n, mesh.corner(next, two) - v))
            return false;
        // On over the edge that we have not come by.
        over = mesh.neighbour(next, k) == t ? two : k;
        t = next;
    }
    return true;
}

}  // namespace

MeshRims rims_of(const TriangleMesh& mesh, int triangle, const TriangleList* refused)
{
    MeshRims rims = mesh.rims(triangle);
    if (!refused) return rims;
    for (int k = 0; k < 3; ++k)
        if (const int next = mesh.neighbour(triangle, k); next >= 0 && refused->has(next))
            rims.rim[k] = Rim::kBorder, rims.sharp[k] = rims.sharp[(k + 1) % 3] = true;
    return rims;
}

MeshFacet facet_of(const TriangleMesh& mesh, int triangle, const TriangleList* refused)
{
    MeshFacet f;
    static_cast<MeshRims&>(f) = rims_of(mesh, triangle, refused);
    for (int k = 0; k < 3; ++k) f.v[k] = mesh.corner(triangle, k);
    f.n = mesh.normal(triangle);
    f.c = dot(f.n, f.v[0]);
    f.index = triangle;
    for (int k = 0; k < 3; ++k) {
        if (f.rim[k] == Rim::kSeam) continue;
        f.beyond[k] = f.rim[k] == Rim::kBorder ? -f.n : mesh.beyond(triangle, k);
    }
    return f;
}

MeshFacet turned(const MeshFacet& f)
{
    MeshFacet t = f;
    t.n = -f.n;
    t.c = -f.c;
    t.v[1] = f.v[2], t.v[2] = f.v[1];
    t.behind = !f.behind;
    for (int k = 0; k < 3; ++k) {
        const Rim rim = f.rim[2 - k];
        t.beyond[k] = -f.beyond[2 - k];
        t.rim[k] = rim == Rim::kConvex ? Rim::kHollow : rim == Rim::kHollow ? Rim::kConvex : rim;
        t.sharp[k] = true;  // not known: the walk around the corner decides
    }
    return t;
}

Crest crest_at_edge(const MeshFacet& f, int edge, Vec3 n)
{
    const Rim rim = f.rim[edge];
    if (!level_or_falls(n, cross(f.n, f.edge(edge)))) return {};  // towards the triangle's own inside
    if (rim == Rim::kBorder) return {.stands = true, .border = true};
    return {.stands = rim == Rim::kConvex && level_or_falls(n, f.into(edge))};
}

Crest crest_at_corner(const TriangleMesh& mesh, const MeshFacet& f, int corner, Vec3 n,
                      const TriangleList* refused)
{
    if (!f.sharp[corner]) return {};
    const Vec3 v = f.v[corner];
    Crest c{.stands = true};
    for (const int j : {1, 2})
        if (!level_or_falls(n, f.v[(corner + j) % 3] - v)) return {};
    const int k = corner_at(mesh, f.index, v);
    if (k < 0) return {};
    if (!falls_around(mesh, refused, f.index, k, v, n, c.border)) return {};
    if (c.border && !falls_around(mesh, refused, f.index, (k + 2) % 3, v, n, c.border)) return {};
    return c;
}

Shows shown_along(const MeshFacet& f, Vec3 direction) { return shown_along(f, direction, kLevel); }

}  // namespace epode
