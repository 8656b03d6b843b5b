// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A triangle of one mesh against one of another, both surfaces of something. Only triangles that cross are
// met. The normal is the least way out of the directions normal to one of the two or across an edge of each,
// of those that both meshes allow: what each triangle shows along it must be its face, or a crest where its
// mesh ends (mesh_facet.h). So the wall of a box that stands on a cut-up floor is pushed up by the floor and
// never aside by the edge of some triangle of it. Manifold: what of one triangle lies behind the other.
#pragma once

#include "collide/pairs/surfaces/terrain_facet.h"

namespace epode {

// A facet in the frame that the contacts are wanted in, and what its corners are asked of: its mesh, which
// has another frame, or the ground, which has this one and never pushes from its back.
struct PlacedFacet {
    MeshFacet f;
    const TriangleMesh* mesh;
    const Pose* pose;  // of the mesh
    const Terrain* terrain = nullptr;
    TerrainPlace place{};  // in the ground
    bool bare = false;     // its rims have not been looked for
    bool one_sided() const { return terrain != nullptr; }
};
struct PlacedCorners {
    Vec3 v[3];
};
PlacedCorners placed_corners(const TriangleMesh& mesh, int triangle, const Pose& pose);
PlacedFacet placed(const TriangleMesh& mesh, int triangle, const Pose& pose, const PlacedCorners& corners);

// What one pair of triangles says: move a by depth * normal.
struct TriangleContact {
    static constexpr int kMax = 6;  // corners of a triangle cut by a triangle's prism, seams left out
    int a = -1, b = -1;             // the triangles
    Vec3 corners_a[3], corners_b[3];
    Vec3 normal;  // from b into a
    Real depth = 0;
    bool allowed = false;  // by both meshes; if not, the least way out, one point
    int count = 0;
    Vec3 points[kMax];
    Real depths[kMax];
    void add(Vec3 point, Real how_deep)
    {
        if (count < kMax) points[count] = point, depths[count++] = how_deep;
    }
    Real overlap_along(Vec3 n) const;  // of the two triangles
};

struct Tolerance {
    Real slack;  // rounding of coordinates
    Real touch;  // what is apart by less touches: what rests must not come and go
};

// False when the two do not cross. A facet of the ground as b may be bare (terrain_facet.h): its rims are
// looked for when they are needed.
bool triangle_triangle(const PlacedFacet& a, PlacedFacet& b, Tolerance tolerance, TriangleContact& out);

}  // namespace epode
