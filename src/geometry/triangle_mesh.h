// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A surface of triangles: vertices that may move, triangles that do not change, and what contacts need to
// know of a triangle's surroundings. Edges are one edge when their ends are the same vertices or vertices at
// exactly equal positions (many programs repeat the vertices for every triangle).
//   flat      an edge whose two triangles differ by less than kFlatSine, or by less than rounding may have
//             tilted them: `grain` is the relative rounding of the coordinates, that of float for float data.
//   crowded   of more than two triangles at an edge, a triangle's neighbour is the one that bounds the space
//             in front of it: the first that is met when its plane is turned about the edge towards its
//             normal (radial-edge order; Weiler 1986). So the floor on either side of a wall meets the wall,
//             the two sides of a doubled sheet are two sheets, and copies of a triangle do no harm. Where
//             more than 32 meet, none has a neighbour.
//   degenerate triangles, whose least altitude is no more than 4 grains of their largest coordinate, keep
//             their numbers and have no normal; neighbours are sought beyond them, over their longest other
//             edge.
//   seams     edges so flat (kSeam) that a manifold goes on beyond them.
// Winding that differs from one triangle to the next is borne: a neighbour is seen as if wound as the one
// that asks.
#pragma once

#include <cstdint>

#include "base/array.h"
#include "base/prefetch.h"
#include "geometry/shapes.h"

namespace epode {

enum class Rim : unsigned char { kSeam, kFlat, kConvex, kHollow, kBorder };

// `beyond` and `crests` are what a contact at the rim of a triangle is judged by: only crests may give
// normals other than n.
struct MeshTriangle {
    Vec3 v[3];
    Vec3 n;          // unit, right-handed from v
    Vec3 beyond[3];  // unit normal of the neighbour over the edge v[k], v[(k+1)%3]; -n where there is none
    std::uint8_t crests;  // bits 0-2: edge k is convex or a border; bits 3-5: such an edge ends at vertex k
};

// The kinds of the three edges of a triangle, and whether a crest may be at corner k.
struct MeshRims {
    Rim rim[3];
    bool sharp[3];
};

struct MeshCorners {
    int at[3];  // vertices
};

class TriangleMesh {
  public:
    static constexpr Real kFlatSine = Real(1e-3);
    static constexpr Real kSeam = kSingle ? Real(1e-4) : Real(1e-5);  // sine below which a manifold goes on
    static constexpr int kMostTriangles = 1 << 27;

    // Takes the arrays over; corners are in range, coordinates usable. False when memory is exhausted: then
    // the mesh and both arrays are as before.
    [[nodiscard]] bool build(Array<Vec3>& vertices, Array<MeshCorners>& triangles, Real grain);

    // For moving vertices; refresh() is due then. What was one edge when the mesh was built stays one.
    Vec3* vertices() { return vertices_.data(); }
    void refresh();

    Real grain() const { return grain_; }
    int vertex_count() const { return vertices_.size(); }
    int triangle_count() const { return triangles_.size(); }
    Vec3 vertex(int i) const { return vertices_.data()[i]; }
    const MeshCorners& corners(int t) const { return triangles_.data()[t]; }
    Vec3 corner(int t, int k) const { return vertex(corners(t).at[k]); }
    Vec3 normal(int t) const { return normals_.data()[t]; }  // zero when degenerate
    bool degenerate(int t) const { return normal(t) == Vec3{}; }
    std::uint8_t crests(int t) const { return crests_.data()[t]; }
    const MeshRims& rims(int t) const { return rims_.data()[t]; }
    int neighbour(int t, int k) const { return across_.data()[3 * t + k] >> 1; }  // over edge k; -1: none

    // Ask for the memory of what contacts look at.
    void prefetch(int t) const
    {
        epode::prefetch<1>(triangles_.data() + t);
        epode::prefetch<1>(rims_.data() + t);
        epode::prefetch<1>(across_.data() + 3 * t);
        prefetch_normal(t);
    }
    void prefetch(const MeshCorners& corners) const
    {
        for (const int v : corners.at) prefetch_vertex(v);
    }
    void prefetch_vertex(int i) const { epode::prefetch<1>(vertices_.data() + i); }
    void prefetch_normal(int t) const { epode::prefetch<1>(normals_.data() + t); }

    // The first corner of a triangle, not a degenerate one, that is the same vertex, as 3 t + k.
    int first_corner(int t, int k) const { return first_.data()[start(3 * t + k)]; }
    int first_corner(int vertex) const
    {
        return first_.data()[vertex];
    }                                 // of a place's first vertex, else -1
    bool leads(int t, int k) const;   // no triangle before t, not a degenerate one, has the edge k
    bool hollow(int t, int k) const;  // the edge k is concave

    // Not of a degenerate one.
    MeshTriangle triangle(int t) const;

    // Unit normal of the neighbour over edge k, as MeshTriangle::beyond.
    Vec3 beyond(int t, int k) const
    {
        const int across = across_.data()[3 * t + k];
        return across < 0 ? -normal(t) : (across & 1) ? -normal(across >> 1) : normal(across >> 1);
    }

    Aabb box(int t) const;
    Aabb box() const;  // of all triangles; the origin when there are none

  private:
    // Half-edge 3 t + k runs from corner k of triangle t to the next one.
    int start(int h) const { return weld_.data()[corners(h / 3).at[h % 3]]; }
    int end(int h) const { return weld_.data()[corners(h / 3).at[(h + 1) % 3]]; }
    Vec3 from(int h) const { return corner(h / 3, h % 3); }
    Vec3 along(int h) const { return corner(h / 3, (h + 1) % 3) - from(h); }
    Vec3 apex(int h) const { return corner(h / 3, (h + 2) % 3); }

    // What lies over a half-edge: the half-edge of the neighbour, and its winding; none: -1.
    struct Over {
        int half_edge = -1;
        bool turned = false;
    };
    [[nodiscard]] bool weld();
    [[nodiscard]] bool link_edges();
    void link_fan(const struct FanEdge* first, int count);
    void measure(int t);
    Over over(int h) const;
    Over beyond_degenerate(int h) const;
    int bend(int h, const Over& found) const;
    void look_over(int h);
    MeshRims rims_of(int t) const;

    Array<Vec3> vertices_;
    Array<MeshCorners> triangles_;
    Array<int> weld_;             // of each vertex: the first at its position
    Array<int> first_;            // of each welded vertex: its first corner, -1: none
    Array<int> next_;             // of each half-edge: the next of the same edge, in a circle by number
    Array<int> across_;           // of each half-edge: 2 neighbour + (1 if wound the other way), or -1
    Array<Vec3> normals_;         // of each triangle
    Array<float> tilt_;           // of each triangle: the sine by which rounding may tilt it
    Array<std::uint8_t> crests_;  // of each triangle
    Array<MeshRims> rims_;        // of each triangle
    Array<std::uint8_t> sharp_;   // of each welded vertex: an edge there crests
    Real grain_ = kEpsilon;
};

}  // namespace epode
