// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The readers of mesh formats, one file each. A reader appends vertices and triangles (every index is that of a vertex)
// and returns false for broken bytes; a problem is only written where there is more to say than that.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// Of one file, all instances counted: a binary STL of the largest file that is read has 5.4 million triangles.
constexpr size_t kMaxTriangles = 6'000'000, kMaxVertices = 6'000'000;

using MeshReader = bool (*)(const std::string& path, const std::string& bytes, Mesh& mesh,
                            std::string& problem);

bool read_stl(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
bool read_obj(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
bool read_collada(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
bool read_glb(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
bool read_msh(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);

}  // namespace epode::robots
