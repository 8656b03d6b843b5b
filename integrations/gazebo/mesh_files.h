// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes and height maps that Gazebo's own loaders have read, or are to read because a file names them.
#pragma once

#include <sdf/Heightmap.hh>
#include <sdf/Mesh.hh>

#include "integrations/gazebo/entities.h"
#include "integrations/gazebo/names.h"
#include "robots/model.h"

namespace epode::gazebo {

// Its triangles.
robots::Mesh mesh_of(const gz::common::Mesh& mesh);
// The shape of a mesh of that scale; of a height map over its size. False, with a message, where it has no geom.
bool make_mesh_of(Shape& shape, const gz::common::Mesh& mesh, Vec scale);
bool make_heights_of(Shape& shape, gz::common::HeightmapData& heights, Vec size, int sampling);
// Paths count from the folder of the file that names them, then as Gazebo looks for files. False, with a message, of a file that is
// not there or cannot be read.
bool read_mesh_file(const ::sdf::Mesh& from, Shape& shape);
bool read_height_file(const ::sdf::Heightmap& from, Shape& shape);

}  // namespace epode::gazebo
