// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A triangle of one mesh against one of another, both surfaces of solids. Only triangles that cross have
// contacts. The normal is the direction of least overlap among the normals of the two and the cross products
// of their edges, of those that both meshes allow: what each triangle shows along it must be its face, or a
// crest where its mesh ends (mesh_facet.h). So a floor of many triangles moves the wall of a box that stands
// on it up, and the edge of one of them never moves it aside. Manifold: the part of one triangle that lies
// behind the other.
#pragma once

#include "collide/pairs/surfaces/terrain_facet.h"
#include "collide/pairs/surfaces/triangle_part.h"

namespace epode {

// A facet in the frame of the contacts, and the source of its corners: its mesh, which has another frame, or
// the terrain, which has this frame and no contacts at its back. Few facets cross another, so what is more than
// corners and plane is found for these alone, by finish().
struct PlacedFacet {
    MeshFacet f;
    const TriangleMesh* mesh;
    const Pose* pose;  // of the mesh
    const Terrain* terrain = nullptr;
    TerrainPlace place{};    // in the terrain
    bool has_rims = false;   // else they are not known yet
    bool has_prism = false;  // the same
    Prism prism{};
    bool one_sided() const { return terrain != nullptr; }
};
void finish(PlacedFacet& facet);
struct PlacedCorners {
    Vec3 v[3];
};
PlacedCorners placed_corners(const TriangleMesh& mesh, int triangle, const Pose& pose);
// Corners and plane.
PlacedFacet placed(const TriangleMesh& mesh, int triangle, const Pose& pose, const PlacedCorners& corners);

// The contact of one pair of triangles: moving a by depth * normal separates the two.
struct TriangleContact {
    static constexpr int kMax = 6;  // corners of a triangle cut by a triangle's prism, seams left out
    TriangleContact() {}
    int count = 0;
    bool allowed = false;  // by both meshes; if not, the least way out, one point
    Real depth = 0;
    Vec3 normal;         // from b into a
    int a = -1, b = -1;  // the triangles
    union {
        Vec3 corners_a[3];  // in unions: left unwritten until found
    };
    union {
        Vec3 corners_b[3];
    };
    union {
        Vec3 points[kMax];
    };
    Real depths[kMax];
    void add(Vec3 point, Real how_deep)
    {
        if (count < kMax) points[count] = point, depths[count++] = how_deep;
    }
    Real overlap_along(Vec3 n) const;  // of the two triangles
};

struct Tolerance {
    Real slack;  // rounding of coordinates
    Real touch;  // a smaller distance counts as touching: contacts of resting meshes must persist
};

// False when the two do not cross; finishes them when they do.
bool triangle_triangle(PlacedFacet& a, PlacedFacet& b, Tolerance tolerance, TriangleContact& out);

}  // namespace epode
