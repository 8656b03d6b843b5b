// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// STL. Binary: 80 bytes, a count, and for each triangle twelve floats (the first three a normal) and two bytes. Text:
// the words "vertex x y z", three to a triangle. Some binary files begin with "solid" as texts do: the size decides.
#include <algorithm>
#include <cstring>
#include <numeric>
#include <tuple>

#include "robots/meshes/formats.h"
#include "robots/meshes/words.h"

namespace epode::robots {

namespace {

constexpr size_t kHead = 84, kTriangle = 50;  // bytes

// Three corners to a triangle. Those at the same place become one vertex, numbered as they first come; triangles with two
// such corners are left out. Sorted, equal ones stand side by side, the first of them in front.
void add_welded(const std::vector<Vec>& corners, Mesh& mesh)
{
    std::vector<std::uint32_t> order(corners.size()), number(corners.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](std::uint32_t i) { return std::tuple(corners[i].x, corners[i].y, corners[i].z, i); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) { return key(i) < key(k); });
    for (size_t i = 0; i < order.size(); ++i) {
        const bool is_new = i == 0 || length(corners[order[i]] - corners[order[i - 1]]) > 0;
        number[order[i]] =
            is_new ? order[i] : number[order[i - 1]];  // for now, the first corner at its place
    }
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
        const bool is_new = number[i] == i;
        if (is_new) mesh.vertices.push_back(corners[i]);
        number[i] = is_new ? std::uint32_t(mesh.vertices.size()) - 1 : number[number[i]];
    }
    for (size_t i = 0; i + 3 <= corners.size(); i += 3) {
        const std::array<std::uint32_t, 3> t{number[i], number[i + 1], number[i + 2]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
    }
}

Vec vec_at(const std::string& bytes, size_t offset)
{
    float values[3];
    std::memcpy(values, bytes.data() + offset, sizeof values);
    return {values[0], values[1], values[2]};
}

bool is_binary(const std::string& bytes, size_t& count)
{
    if (bytes.size() < kHead) return false;
    std::uint32_t n;
    std::memcpy(&n, bytes.data() + 80, 4);
    count = n;
    const size_t wanted = kHead + kTriangle * count;
    return bytes.size() == wanted || (bytes.size() > wanted && !bytes.starts_with("solid"));
}

bool read_binary(const std::string& bytes, size_t count, std::vector<Vec>& corners)
{
    corners.resize(3 * count);
    for (size_t i = 0; i < corners.size(); ++i) {
        corners[i] = vec_at(bytes, kHead + kTriangle * (i / 3) + 12 + 12 * (i % 3));
        if (!is_finite(corners[i])) return false;
    }
    return true;
}

bool read_text(const std::string& text, std::vector<Vec>& corners)
{
    Words words(text);
    for (std::string_view word; words.next(word);)
        if (word == "vertex" && !words.vec(corners.emplace_back())) return false;
    return true;
}

}  // namespace

bool read_stl(const std::string&, const std::string& bytes, Mesh& mesh, std::string&)
{
    size_t count = 0;
    std::vector<Vec> corners;
    if (!(is_binary(bytes, count) ? read_binary(bytes, count, corners) : read_text(bytes, corners)))
        return false;
    if (corners.size() > 3 * kMaxTriangles) return false;
    add_welded(corners, mesh);
    return true;
}

}  // namespace epode::robots
