// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_facet.h. The edges around a corner are found by walking from neighbour to neighbour, both ways
// until the walk is closed or a border ends it.
#include "collide/pairs/mesh_facet.h"

namespace epode {

namespace {

constexpr Real kLevel = kSingle ? Real(1e-4) : Real(1e-6);  // sine of an angle that counts as flat
constexpr Real kSeam = kSingle ? Real(1e-4) : Real(1e-5);   // sine below which a patch goes on
constexpr int kMostAround = 256;                            // triangles at a corner

// `tilt`: n . into, negative when the neighbour falls away.
Rim rim_of(bool crest, bool border, Real tilt)
{
    if (border) return Rim::kBorder;
    if (std::fabs(tilt) <= kSeam) return Rim::kSeam;
    if (crest) return Rim::kConvex;
    return tilt > TriangleMesh::kFlatSine ? Rim::kHollow : Rim::kFlat;
}

bool level_or_falls(Vec3 n, Vec3 along) { return dot(n, along) <= kLevel * length(along); }

int corner_at(const TriangleMesh& mesh, int t, Vec3 v)
{
    for (int k = 0; k < 3; ++k)
        if (mesh.corner(t, k) == v) return k;
    return -1;
}

// Walks around v from triangle t over its edge `over`.
bool falls_around(const TriangleMesh& mesh, int t, int over, Vec3 v, Vec3 n, bool& border)
{
    const int first = t;
    for (int steps = 0; steps < kMostAround; ++steps) {
        const int next = mesh.neighbour(t, over);
        if (next == first) return true;
        if (next < 0) {
            border = true;
            return true;
        }
        const int k = corner_at(mesh, next, v);
        if (k < 0) return true;  // beyond triangles without area: the corner ends here
        for (const int j : {(k + 1) % 3, (k + 2) % 3})
            if (!level_or_falls(n, mesh.corner(next, j) - v)) return false;
        // On over the edge that we have not come by.
        over = mesh.neighbour(next, k) == t ? (k + 2) % 3 : k;
        t = next;
    }
    return true;
}

}  // namespace

MeshFacet facet_of(const TriangleMesh& mesh, int triangle)
{
    const MeshTriangle t = mesh.triangle(triangle);
    MeshFacet f;
    f.n = t.n;
    f.c = dot(t.n, t.v[0]);
    f.index = triangle;
    for (int k = 0; k < 3; ++k) {
        f.v[k] = t.v[k];
        const Vec3 edge = t.v[(k + 1) % 3] - t.v[k];
        f.into[k] = normalized_or(cross(edge, t.beyond[k]), {});
        const bool border = mesh.neighbour(triangle, k) < 0 || t.beyond[k] == -t.n;
        f.rim[k] = rim_of((t.crests >> k & 1) != 0, border, dot(t.n, f.into[k]));
        f.sharp[k] = (t.crests >> (3 + k) & 1) != 0;
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
        t.into[k] = f.into[2 - k];
        t.rim[k] = rim == Rim::kConvex ? Rim::kHollow : rim == Rim::kHollow ? Rim::kConvex : rim;
        t.sharp[k] = true;  // not known: the walk around the corner tells
    }
    return t;
}

Crest crest_at_edge(const MeshFacet& f, int edge, Vec3 n)
{
    const Rim rim = f.rim[edge];
    if (!level_or_falls(n, cross(f.n, f.edge(edge)))) return {};  // towards the triangle's own inside
    if (rim == Rim::kBorder) return {true, true};
    return {rim == Rim::kConvex && dot(n, f.into[edge]) <= kLevel, false};
}

Crest crest_at_corner(const TriangleMesh& mesh, const MeshFacet& f, int corner, Vec3 n)
{
    if (!f.sharp[corner]) return {};
    const Vec3 v = f.v[corner];
    const int k = corner_at(mesh, f.index, v);
    if (k < 0) return {};
    Crest c{true, false};
    for (const int j : {1, 2})
        if (!level_or_falls(n, f.v[(corner + j) % 3] - v)) return {};
    if (!falls_around(mesh, f.index, k, v, n, c.border)) return {};
    if (c.border && !falls_around(mesh, f.index, (k + 2) % 3, v, n, c.border)) return {};
    return c;
}

Shows shown_along(const MeshFacet& f, Vec3 direction) { return shown_along(f, direction, kLevel); }

}  // namespace epode
