// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The growing hull as triangles over grid points (quickhull.cpp), and its faces when it stands. Signs are
// exact: coordinates have at most 40 bits, so the determinant
//   (b - a) x (c - a) . (d - a)      has at most 3 * 41 + 3 = 126.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/array.h"
#include "geometry/hulls/quickhull.h"

namespace epode {

inline constexpr std::int64_t kHullGrid = std::int64_t(1) << 40;

struct GridPoint {
    std::int64_t x[3];
    int source;  // index of the client's point
};

inline bool same_place(const GridPoint& a, const GridPoint& b)
{
    return a.x[0] == b.x[0] && a.x[1] == b.x[1] && a.x[2] == b.x[2];
}

// Doubles whatever Real is.
struct Vec3d {
    double x = 0, y = 0, z = 0;
    double dot(const Vec3d& o) const { return x * o.x + y * o.y + z * o.z; }
    Vec3d cross(const Vec3d& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
    double length() const { return std::sqrt(dot(*this)); }
};

// Exact.
inline Vec3d between(const GridPoint& a, const GridPoint& b)
{
    return {double(b.x[0] - a.x[0]), double(b.x[1] - a.x[1]), double(b.x[2] - a.x[2])};
}

struct HullFacet {
    int v[3];
    int neighbour[3];     // beyond the edge from v[k] to v[k + 1]
    Vec3d n;              // unit, outward
    double area;          // twice
    double height;        // of `farthest`
    int farthest, above;  // points: the highest one, and the first of the list; -1: none
    int age;              // counts the facets of a slot
    bool gone, seen, fresh;
};

// Positive: d is beyond the plane of a, b, c, which run counter-clockwise seen from outside.
int side_of(const Array<GridPoint>& points, int a, int b, int c, int d);
HullFacet plane_through(const Array<GridPoint>& points, int a, int b, int c);

struct HullMesh {
    Array<GridPoint> points;
    Array<HullFacet> facets;
    double extent = 0;  // of the client's points: the length of kHullGrid steps
    double height(int facet, int point) const
    {
        return facets[facet].n.dot(between(points[facets[facet].v[0]], points[point]));
    }
};

// Facets within `flat` grid steps of one plane become one face. False without memory.
bool gather_faces(const HullMesh& mesh, double flat, Hull& out);

}  // namespace epode
