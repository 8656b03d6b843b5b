// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A reader of meshes on any bytes: what it accepts has good indices and finite vertices, and a solid can be made of it.
#include <cstdint>
#include <cstdlib>

#include "limit.h"
#include "robots/meshes/meshes.h"
#include "robots/meshes/solid.h"

using namespace epode::robots;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const epode::fuzz::TimeLimit limit;
    Mesh mesh;
    std::string problem;
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    if (!read_mesh("fuzz." EPODE_ENDING, bytes, mesh, problem)) {
        if (problem.empty()) std::abort();
        return 0;
    }
    for (Vec v : mesh.vertices)
        if (!is_finite(v)) std::abort();
    for (const auto& t : mesh.triangles)
        for (std::uint32_t corner : t)
            if (corner >= mesh.vertices.size()) std::abort();
    scale_mesh(mesh, {1, -2, 1});
    Solid solid;
    (void)solid_of(mesh, solid);
    return 0;
}
