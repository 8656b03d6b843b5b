// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is said of a triangle and of its edges by the corners alone, for meshes (triangle_mesh.h) and for
// other surfaces that meshes meet: the normal and how far rounding may have tilted it, the turn of the
// neighbour about an edge, and the kind of edge that makes. One owner, so that a surface has the same edges
// however it is kept.
#pragma once

#include <algorithm>

#include "geometry/triangle_mesh.h"

namespace epode {

struct TriangleLie {
    Vec3 n;          // unit; zero when degenerate
    float tilt = 0;  // the sine by which rounding may tilt it
};

// The largest component is taken out, so that neither tiny nor huge triangles are lost.
inline TriangleLie lie_of(const Vec3 (&v)[3], Real grain)
{
    const Real largest = max_component(max(abs(v[0]), max(abs(v[1]), abs(v[2]))));
    const Vec3 sides[3] = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
    const Real m = max_component(max(abs(sides[0]), max(abs(sides[1]), abs(sides[2]))));
    if (!(m > 0)) return {};
    Real longest2 = 0;
    for (const Vec3 s : sides) longest2 = std::max(longest2, length2(s / m));
    Vec3 n = cross(sides[0] / m, sides[1] / m);
    const Real altitude = m * (length(n) / std::sqrt(longest2));
    if (!(altitude > 4 * grain * largest) || !normalize(n)) return {};
    return {n, float(grain * largest / altitude)};
}

// A sheet seen along an edge, from a triangle at the same edge.
struct SheetTurn {
    Real cosine, sine;
    Real growing(Real flat) const
    {
        const bool behind = cosine > 0 && sine <= flat;
        return sine > 0 && !behind ? 1 - cosine : 3 + cosine;
    }
    bool convex(Real flat) const { return sine < -flat || (cosine > 0 && sine <= flat); }
};

inline SheetTurn sheet_turn(Vec3 apex, Vec3 from, Vec3 edge, Vec3 n)
{
    Vec3 w = apex - from;
    w = normalized_or(w - dot(w, edge) * edge, {});
    return {dot(cross(n, edge), w), dot(n, w)};
}

// The sine below which an edge is flat, rounding of both its triangles included.
inline Real flat_sine(float tilt, float other)
{
    return std::max(TriangleMesh::kFlatSine, 2 * Real(std::max(tilt, other)));
}

// Of an edge that is no border.
inline Rim rim_of(Vec3 n, Vec3 edge, Vec3 beyond, bool crest)
{
    const Real tilt =
        dot(n, normalized_or(cross(edge, beyond), {}));  // negative when the neighbour falls away
    if (std::fabs(tilt) <= TriangleMesh::kSeam) return Rim::kSeam;
    if (crest) return Rim::kConvex;
    return tilt > TriangleMesh::kFlatSine ? Rim::kHollow : Rim::kFlat;
}

}  // namespace epode
