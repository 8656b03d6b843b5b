// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two meshes, and a mesh on a height field. The triangles of the first that lie in the second's box are
// tested one by one (triangle_triangle.h), against the second's tree or the grid of the field
// (terrain_facet.h). Of a field at most 256 by 256 cells are tested, the middle ones. Nothing is allocated
// unless more than 40 pairs of triangles cross.
#pragma once

#include "collide/pairs/surfaces/mesh_contacts.h"
#include "collide/surfaces/heightfield.h"

namespace epode {

// Contacts in the world; side1 and side2 are the triangles.
void mesh_mesh_contacts(const Surface& a, const Pose& A, const Surface& b, const Pose& B, ContactSink& sink);

// side1 is the mesh's triangle.
void mesh_terrain_contacts(const Surface& a, const Pose& A, const HeightfieldData& field, const Pose& B,
                           ContactSink& sink);

}  // namespace epode
