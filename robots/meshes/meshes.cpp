// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See meshes.h.
#include "robots/meshes/meshes.h"

#include <algorithm>

#include "robots/files/files.h"
#include "robots/meshes/formats.h"

namespace epode::robots {

namespace {

struct Format {
    const char* ending;
    MeshReader read;
};
constexpr Format kFormats[] = {
    {"stl", &read_stl}, {"obj", &read_obj}, {"dae", &read_collada}, {"glb", &read_glb}, {"msh", &read_msh}};

const Format* format_of(const std::string& path)
{
    const std::string ending = ending_of(path);
    const auto found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                    [&](const Format& format) { return ending == format.ending; });
    return found == std::end(kFormats) ? nullptr : found;
}

}  // namespace

bool is_mesh_path(const std::string& path, std::string& problem)
{
    if (format_of(path)) return true;
    problem = "'" + path + "': meshes are read from .stl, .obj, .dae, .glb and .msh";
    return false;
}

bool read_mesh(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem)
{
    if (!is_mesh_path(path, problem)) return false;
    mesh.path = path;
    const bool is_read = format_of(path)->read(path, bytes, mesh, problem);
    if (is_read && !mesh.triangles.empty() && mesh.triangles.size() <= kMaxTriangles) return true;
    problem = "'" + path + "' " + (problem.empty() ? "is broken or has no triangles" : problem);
    return false;
}

void scale_mesh(Mesh& mesh, Vec factors)
{
    mesh.scale = factors;
    for (Vec& v : mesh.vertices) v = scaled(v, factors);
    if (factors.x * factors.y * factors.z < 0)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace epode::robots
