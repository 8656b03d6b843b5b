// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Facets of a height field as a mesh meets them: with the kinds of their edges, as if the ground were a mesh,
// found from the samples around when they are asked for. Walls at holes are facets, too: convex rims above,
// plain bottoms below, seams where they go on. Rejected: a mesh of the ground near, with its tree, made for
// every call: a hundred times the work, and memory.
#pragma once

#include "collide/pairs/surfaces/mesh_facet.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

// The facet in the grid that a triangle of the ground is, or that it is a wall of.
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
