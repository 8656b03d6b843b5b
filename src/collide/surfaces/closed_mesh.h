// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes that enclose a solid. Closed is one in which every triangle that has an area meets another one over
// each of its edges, wound so that both look to the same side, and that looks outward on the whole (its
// volume is positive). The nearest point of the surface decides whether a point is inside: with the pseudo
// normal there, that of a triangle, the sum of two at an edge, at a corner the sum weighted by the angles of
// the triangles that meet there (Baerentzen and Aanaes 2005). Rejected: counting what a ray crosses, which
// must not go through an edge, and the winding number, which needs every triangle.
#pragma once

#include "bvh/mesh_tree.h"

namespace epode {

bool is_closed(const TriangleMesh& mesh);

// The shortest way from a point to the surface.
struct WayOut {
    Vec3 nearest;
    Vec3 normal;  // unit, outward
    int triangle = -1;
};

// Of a closed mesh. False: the point is not inside.
bool way_out_of(const TriangleMesh& mesh, const MeshTree& tree, Vec3 point, WayOut& out);

}  // namespace epode
