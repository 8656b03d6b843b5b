// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// MSH, MuJoCo's old binary format: four ints (counts of vertices, normals, texture coordinates and triangles), then
// floats, 3 to a vertex, 3 to a normal, 2 to a texture coordinate, and 3 ints to a triangle. (MuJoCo's documentation,
// XML Reference, "mesh".)
#include <cstring>

#include "robots/meshes/formats.h"

namespace epode::robots {

namespace {

constexpr size_t kCounts = 16;

template <class Number>
std::array<Number, 3> three_at(const std::string& bytes, size_t at)
{
    std::array<Number, 3> out;
    std::memcpy(out.data(), bytes.data() + at, sizeof out);
    return out;
}

}  // namespace

bool read_msh(const std::string&, const std::string& bytes, Mesh& mesh, std::string&)
{
    std::uint32_t counts[4];
    if (bytes.size() < kCounts) return false;
    std::memcpy(counts, bytes.data(), kCounts);
    const size_t vertices = counts[0], triangles = counts[3];
    const size_t first_triangle = kCounts + 12 * vertices + 12 * size_t(counts[1]) + 8 * size_t(counts[2]);
    if (bytes.size() != first_triangle + 12 * triangles) return false;
    for (size_t i = 0; i < vertices; ++i) {
        const auto v = three_at<float>(bytes, kCounts + 12 * i);
        mesh.vertices.push_back({v[0], v[1], v[2]});
        if (!is_finite(mesh.vertices.back())) return false;
    }
    for (size_t i = 0; i < triangles; ++i) {
        mesh.triangles.push_back(three_at<std::uint32_t>(bytes, first_triangle + 12 * i));
        for (std::uint32_t corner : mesh.triangles.back())
            if (corner >= vertices) return false;
    }
    return true;
}

}  // namespace epode::robots
