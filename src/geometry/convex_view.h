// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex solid as the general algorithms see it: its farthest point in a direction, the flat feature that
// looks that way, and a radius by which the whole is inflated (spheres and capsules are a point and a segment
// with a radius). The view does not own the shape. Directions and points of the callbacks are in the shape's
// own frame. A view also says which of its local axes are symmetric face normals and which are edge
// directions: with those the penetration of the primitives is refined to rounding (least_overlap, in epa.h).
// Only a shape that is symmetric about its origin may name axes; a polyhedron leaves both empty and lists its
// faces and edges.
#pragma once

#include <span>

#include "geometry/clip.h"
#include "geometry/shapes.h"

namespace epode {

struct PolyhedronFace {
    Vec3 normal;       // unit, outward
    Real offset;       // normal . x <= offset holds in the solid
    int first, count;  // of the corners
};

// An edge between two faces, from one vertex to the other; seen from outside the left face is on its left, so
// that left.normal x right.normal points along it.
struct PolyhedronEdge {
    int from, to;
    int left, right;
    Real cos_half;  // of the angle between the normals
};

// What a view shows, for algorithms that know it better than through its functions.
// kCurved: known by its functions alone, and curved somewhere (curved_overlap.h).
enum class SolidKind : unsigned char { kOther, kPoint, kSegment, kBox, kCylinder, kPolyhedron, kCurved };

struct ConvexView {
    const void* shape = nullptr;
    SolidKind kind = SolidKind::kOther;  // `shape` is then the Sphere, Capsule, Box, Cylinder or Polyhedron
    unsigned char base_axes = 0;         // bit i: -column i is a face normal, of a shape without symmetry
    Vec3 (*local_support)(const void* shape, Vec3 direction) = nullptr;
    // Face (counter-clockwise from outside), segment or point that looks most along `direction`: where two
    // faces do so alike, what they share.
    void (*local_feature)(const void* shape, Vec3 direction, Polygon& out) = nullptr;
    Pose pose;
    Real radius = 0;                          // inflation
    Real size = 1;                            // farthest point from the pose's origin, without the radius
    int face_axes = 0;                        // bit i: +-column i is a face normal
    int edge_axes = 0;                        // bit i: straight edges or side lines run along column i
    Real rim_radius = 0;                      // > 0: round rims about column 2
    std::span<const PolyhedronFace> faces{};  // of a polyhedron, in its own frame
    std::span<const Vec3> edges{};            // and the directions of its edges, of a large one none

    Vec3 support(Vec3 direction) const
    {
        return pose.to_world(local_support(shape, transposed_times(pose.R, direction)));
    }
    void feature(Vec3 direction, Polygon& out) const
    {
        const int first = out.count;
        local_feature(shape, transposed_times(pose.R, direction), out);
        for (int i = first; i < out.count; ++i) out.points[i] = pose.to_world(out.points[i]);
        out.normal = pose.R * out.normal;
    }
};

// Whether two faces look in a direction alike, `size` being its length and a lean the size less the dot
// product with a face's normal: the lesser lean is more than a hair and not much less than the other.
constexpr bool lean_alike(Real lesser, Real other, Real size)
{
    constexpr Real kHair = Real(1e-6), kAlike = Real(0.7);
    return lesser > kHair * size && lesser > kAlike * other;
}

ConvexView view_of(const Sphere& sphere, const Pose& pose);
ConvexView view_of(const Box& box, const Pose& pose);
ConvexView view_of(const Capsule& capsule, const Pose& pose);
ConvexView view_of(const Cylinder& cylinder, const Pose& pose);
ConvexView view_of(const Convex& convex, const Pose& pose);

// A round end is drawn as a polygon of this many corners; a true rim point is added where it is deepest.
inline constexpr int kRimPoints = 8;
// A disc across z at that height, seen from the side (1 or -1) that it looks to, as such a polygon.
void add_disc(Real radius, Real z, Real side, Polygon& out);

}  // namespace epode
