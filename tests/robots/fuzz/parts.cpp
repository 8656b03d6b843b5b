// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex decomposition of any triangles: three bytes of a vertex, its coordinates in sixteenths, then three of a triangle.
// What it accepts covers the vertices that triangles use, has no more hulls than were allowed, and reports finite numbers.
#include <cstdint>
#include <cstdlib>

#include "robots/parts/decompose.h"

using namespace epode::robots;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size < 24 || size > 400) return 0;
    const size_t vertices = 4 + data[0] % 28, bytes = 2 + 3 * vertices;
    if (size < bytes + 3) return 0;
    Mesh mesh;
    const auto coordinate = [&](size_t i) { return double(std::int8_t(data[2 + i])) / 16; };
    for (size_t i = 0; i < vertices; ++i)
        mesh.vertices.push_back({coordinate(3 * i), coordinate(3 * i + 1), coordinate(3 * i + 2)});
    for (size_t at = bytes; at + 3 <= size; at += 3)
        mesh.triangles.push_back({std::uint32_t(data[at] % vertices), std::uint32_t(data[at + 1] % vertices),
                                  std::uint32_t(data[at + 2] % vertices)});
    PartSettings settings;
    settings.max_parts = 1 + data[1] % 8, settings.max_vertices = 0;
    Decomposition out;
    std::string problem;
    if (!decompose(mesh, settings, out, problem)) {
        if (problem.empty()) std::abort();
        return 0;
    }
    if (out.hulls.empty() || int(out.hulls.size()) > settings.max_parts) std::abort();
    if (!std::isfinite(out.surplus) || out.uncovered != 0) std::abort();
    for (const auto& t : mesh.triangles)
        for (std::uint32_t corner : t) {
            double height = HUGE_VAL;
            for (const Hull& hull : out.hulls) height = std::min(height, hull.height(mesh.vertices[corner]));
            if (!(height < 1e-4)) std::abort();
        }
    return 0;
}
