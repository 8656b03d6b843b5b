// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// STL. Binary: 80 bytes, a count, and for each triangle twelve floats (the first three a normal) and two bytes. Text:
// the words "vertex x y z", three to a triangle. Some binary files begin with "solid" as texts do: the size decides.
#include <cstring>
#include <map>

#include "robots/meshes/formats.h"
#include "robots/meshes/words.h"

namespace epode::robots {

namespace {

constexpr size_t kHead = 84, kTriangle = 50;  // bytes

// Corners at the same place become one vertex; triangles with two such corners are left out.
class Corners {
  public:
    explicit Corners(Mesh& mesh) : mesh_(mesh) {}
    void triangle(const std::array<Vec, 3>& corners)
    {
        std::array<std::uint32_t, 3> t;
        for (size_t i = 0; i < 3; ++i) t[i] = number_of(corners[i]);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh_.triangles.push_back(t);
    }

  private:
    std::uint32_t number_of(Vec v)
    {
        const auto [it, is_new] = numbers_.try_emplace({v.x, v.y, v.z}, std::uint32_t(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back(v);
        return it->second;
    }
    Mesh& mesh_;
    std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

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

bool read_binary(const std::string& bytes, size_t count, Mesh& mesh)
{
    Corners corners(mesh);
    for (size_t t = 0; t < count; ++t) {
        std::array<Vec, 3> three;
        for (size_t i = 0; i < 3; ++i) {
            three[i] = vec_at(bytes, kHead + kTriangle * t + 12 + 12 * i);
            if (!is_finite(three[i])) return false;
        }
        corners.triangle(three);
    }
    return true;
}

bool read_text(const std::string& text, Mesh& mesh)
{
    Words words(text);
    Corners corners(mesh);
    std::array<Vec, 3> three;
    size_t filled = 0;
    for (std::string_view word; words.next(word);) {
        if (word != "vertex") continue;
        if (!words.vec(three[filled])) return false;
        if (++filled == 3) corners.triangle(three), filled = 0;
    }
    return true;
}

}  // namespace

bool read_stl(const std::string&, const std::string& bytes, Mesh& mesh, std::string&)
{
    size_t count = 0;
    return is_binary(bytes, count) ? read_binary(bytes, count, mesh) : read_text(bytes, mesh);
}

}  // namespace epode::robots
