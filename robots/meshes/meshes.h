// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles from files: STL (binary and text), OBJ (corners and faces), DAE (geometry of the scene, in metres, z up), GLB (the same, the axes of the file), MSH.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// False and a problem: the ending is none of these.
bool is_mesh_path(const std::string& path, std::string& problem);
// False and a problem: another kind of file, a broken one, no triangles, numbers that are not finite.
bool read_mesh(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
// Factors of an odd number of mirrors turn the triangles round.
void scale_mesh(Mesh& mesh, Vec factors);

}  // namespace epode::robots
