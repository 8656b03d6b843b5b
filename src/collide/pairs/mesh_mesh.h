// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two meshes, and a mesh on a height field, whose facets near it are made a mesh for the time. The triangles
// of the first that lie in the second's box are asked about one by one in the second's tree
// (triangle_triangle.h).
#pragma once

#include "collide/heightfield.h"
#include "collide/pairs/mesh_contacts.h"

namespace epode {

// Contacts in the world; side1 and side2 are the triangles.
void mesh_mesh_contacts(const Surface& a, const Pose& A, const Surface& b, const Pose& B, ContactSink& sink);

// side1 is the mesh's triangle.
void mesh_ground_contacts(const Surface& a, const Pose& A, const HeightfieldData& ground, const Pose& B,
                          ContactSink& sink);

}  // namespace epode
