// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See scene.h.
#include "robots/meshes/scene.h"

#include "robots/meshes/formats.h"

namespace epode::robots {

namespace {

bool is_mirror(const Matrix& m)
{
    const Vec x{m[0][0], m[1][0], m[2][0]}, y{m[0][1], m[1][1], m[2][1]}, z{m[0][2], m[1][2], m[2][2]};
    return dot(cross(x, y), z) < 0;
}

}  // namespace

bool add_part(const Part& part, const Affine& where, Mesh& mesh)
{
    const size_t base = mesh.vertices.size();
    if (base + part.vertices.size() > kMaxVertices) return false;
    if (mesh.triangles.size() + part.triangles.size() > kMaxTriangles) return false;
    for (Vec v : part.vertices) {
        mesh.vertices.push_back(where * v);
        if (!is_finite(mesh.vertices.back())) return false;
    }
    const bool turns_round = is_mirror(where.linear);
    for (auto t : part.triangles) {
        for (std::uint32_t& corner : t) corner += std::uint32_t(base);
        if (turns_round) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
    }
    return true;
}

}  // namespace epode::robots
