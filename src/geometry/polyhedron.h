// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex polyhedron, checked and ordered once so that the pair functions need not trust its maker:
//   vertices  relative to the middle of their bounding box, so that a solid far from its origin keeps its
//   digits faces     unit outward normal n and offset d, the solid being all x with n . x <= d; corners
//   counter-clockwise
//             from outside. Given faces that lie in one plane become one, with all vertices of that plane: a
//             cube made of 12 triangles stands on four corners.
//   edges     directions, each once up to sign
// The planes are computed from the points. Rejected: the hull of the points (quickhull), which would hide
// faults of the data; here what is not convex, or not closed, is refused.
#pragma once

#include "base/array.h"
#include "geometry/convex_view.h"

namespace epode {

class Polyhedron {
  public:
    using Face = PolyhedronFace;

    // Faces as ODE gives them: for each of `faces` the number of corners, then the corners. Null when built;
    // else the reason, and *this is as before.
    const char* build(const Real* points, unsigned count, const unsigned* polygons, unsigned faces);

    void swap(Polyhedron& other);

    Vec3 centre() const { return centre_; }
    Real size() const { return size_; }  // farthest vertex from the centre
    std::span<const Vec3> vertices() const { return vertices_.span(); }
    std::span<const Face> faces() const { return faces_.span(); }
    std::span<const Vec3> edges() const { return edges_.span(); }

    Vec3 support(Vec3 direction) const { return vertices_[farthest(direction)]; }
    // The face that holds the farthest vertex and looks most along the direction.
    void feature(Vec3 direction, Polygon& out) const;

  private:
    int farthest(Vec3 direction) const;
    bool take_points(const Real* points, unsigned count);
    const char* take_face(const unsigned* corners, unsigned count);
    bool take_corners(Face& face, const unsigned* own, unsigned count);
    bool take_edges();
    bool closed() const;

    Array<Vec3> vertices_;
    Array<Face> faces_;
    Array<int> corners_;
    Array<Vec3> edges_;
    Vec3 centre_, inside_;  // inside_: the mean of the vertices
    Real size_ = 0;
};

}  // namespace epode
