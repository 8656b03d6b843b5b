// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Facets of a height field for a pair with a mesh. They have the kinds of their edges, as if the terrain were
// a mesh, computed from the surrounding samples on request. Walls at holes are facets, too: convex rims
// above, plain bottoms below, seams where they continue. Rejected: a mesh of the terrain nearby with its
// tree, built for every call: a hundred times the work, and memory.
#pragma once

#include "collide/pairs/surfaces/mesh_facet.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

// The facet of the grid that a triangle of the terrain is, or whose wall it is.
struct TerrainPlace {
    Facet facet{};
    bool wall = false;
};

// Corners, normal and plane only; false for one without area.
bool bare_terrain_facet(const Facet& facet, MeshFacet& f);
// The rest.
void find_terrain_rims(const Terrain& terrain, const TerrainPlace& place, MeshFacet& f);

// The wall under side k of a facet, with all that belongs to it; false when there is none.
bool terrain_walls(const Terrain& terrain, const Facet& facet, int k, MeshFacet (&walls)[2]);

// As crest_at_corner() of meshes.
bool terrain_crests_at_corner(const Terrain& terrain, const TerrainPlace& place, int corner, Vec3 n);

}  // namespace epode
