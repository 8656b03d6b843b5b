// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex polyhedron, made once so that the pair functions need not trust its maker: always the hull of its
// points (quickhull.h), whatever faces came with them.
//   vertices  relative to the middle of their bounding box, so that a solid far from its origin keeps its
//   digits faces     unit outward normal n and offset d, the solid being all x with n . x <= d; corners
//             counter-clockwise from outside. What lies in one plane is one face: a cube made of 12 triangles
//             stands on four corners.
//   edges     between two faces, and their directions, each once up to sign; of the latter none are listed of
//             a solid with more than kNamedFaces faces
//   inner     the mean of the vertices, and the least distance from there to a face: a ball within the solid
// The farthest vertex is found by trying all of them when they are few, else by climbing from neighbour to
// neighbour: in a convex solid who has no better neighbour is best.
#pragma once

#include "base/array.h"
#include "base/streams/structure_stream.h"
#include "geometry/convex_view.h"
#include "geometry/dot_lanes.h"
#include "geometry/inertia.h"

namespace epode {

class Polyhedron {
  public:
    using Face = PolyhedronFace;
    static constexpr int kNamedFaces = 64;

    // The hull of the points, with at most so many vertices; `plates`: points in one plane make a plate
    // without thickness. Null when built; else the reason, and *this is as before.
    const char* build(const Real* points, unsigned count, int max_vertices, bool plates);

    void swap(Polyhedron& other);
    // Of what is loaded, faces are checked to be flat polygons that close (Euler: V - E + F = 2).
    void structure(StructureStream& stream);

    Vec3 centre() const { return centre_; }
    Real size() const { return size_; }  // farthest vertex from the centre
    std::span<const Vec3> vertices() const { return vertices_.span(); }
    std::span<const Face> faces() const { return faces_.span(); }
    std::span<const int> corners() const { return corners_.span(); }
    std::span<const Vec3> edges() const { return edges_.span(); }
    std::span<const PolyhedronEdge> seams() const { return seams_.span(); }
    const DotLanes& face_lanes() const { return face_lanes_; }
    Vec3 inner() const { return inner_; }
    Real inner_radius() const { return inner_radius_; }

    // From the lowest to the farthest vertex along it.
    void extent(Vec3 direction, Real& low, Real& high) const;
    Real reach(Vec3 direction) const;
    Vec3 support(Vec3 direction) const { return vertices_[farthest(direction)]; }
    // The face that holds the farthest vertex and looks most along the direction; the edge or vertex between
    // faces that do so alike.
    void feature(Vec3 direction, Polygon& out) const;
    // Of the solid in its own frame, at density 1.
    MassProperties mass() const;

  private:
    int farthest(Vec3 direction) const;
    int climb(Vec3 direction) const;
    const char* take_hull(std::span<const Vec3> points, int max_vertices);
    const char* take_plate(std::span<const Vec3> points);
    bool take_vertices(std::span<const Vec3> points, std::span<const int> chosen);
    bool take_face(std::span<const int> corners, Vec3 fallback);
    bool take_edges();
    bool take_seams();
    void add_shared(const Face& f, const Face& g, Vec3 top, Polygon& out) const;
    void take_inner();
    bool take_neighbours();
    bool take_lanes();
    bool take_all();
    bool load_faces(StructureStream& stream);

    Array<Vec3> vertices_;
    Array<Face> faces_;
    Array<int> corners_;
    Array<Vec3> edges_;
    Array<PolyhedronEdge> seams_;
    DotLanes vertex_lanes_, face_lanes_;
    // Of vertex i: the vertices at the other ends of its edges, and the faces to the left of those, from
    // first_[i] to first_[i + 1]. Only of solids with many vertices.
    Array<int> first_, neighbours_, around_;
    int start_[8] = {};  // for each octant a vertex that lies far that way
    Vec3 centre_, inner_;
    Real size_ = 0, inner_radius_ = 0;
};

}  // namespace epode
