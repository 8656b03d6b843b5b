// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A triangle of one mesh against one of another, both surfaces of something. Only triangles that cross are met.
// The normal is the least way out of the directions normal to one of the two or across an edge of each, of
// those that both meshes allow: what each triangle shows along it must be its face, or a crest where its mesh
// ends (mesh_facet.h). So the wall of a box that stands on a cut-up floor is pushed up by the floor and never
// aside by the edge of some triangle of it. Manifold: what of one triangle lies behind the other.
#pragma once

#include "collide/pairs/mesh_facet.h"

namespace epode {

// A facet in the frame that the contacts are wanted in, and its mesh, which has another.
struct PlacedFacet {
    MeshFacet f;
    const TriangleMesh& mesh;
    const Pose& pose;  // of the mesh
};
PlacedFacet placed(const TriangleMesh& mesh, int triangle, const Pose& pose);

// What is left when both meshes allow nothing: the least way out of one pair.
struct LastResort {
    Real depth = kInf;
    ContactPoint point;
};

// Normals point from b into a; side1 and side2 are the triangles.
void triangle_triangle(const PlacedFacet& a, const PlacedFacet& b, Real slack, Harvest& out, LastResort& last);

}  // namespace epode
