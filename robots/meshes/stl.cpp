// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// STL. Binary: 80 bytes, a count, and for each triangle twelve floats (the first three a normal) and two bytes. Text:
// the words "vertex x y z", three to a triangle. Some binary files begin with "solid" as texts do: the size decides.
#include <bit>
#include <cstring>

#include "robots/meshes/formats.h"
#include "robots/meshes/words.h"

namespace epode::robots {

namespace {

constexpr size_t kHead = 84, kTriangle = 50;  // bytes

// The vertices of a mesh by their place: slots with open addressing, from the bits of the coordinates.
class Places {
  public:
    explicit Places(size_t corners) : slots_(std::bit_ceil(2 * corners + 1), kNone) {}

    // The number of the vertex at that place, which is added if there is none.
    std::uint32_t number_of(Vec v, std::vector<Vec>& vertices)
    {
        for (size_t slot = hash(v);; ++slot) {
            std::uint32_t& its = slots_[slot & (slots_.size() - 1)];
            if (its == kNone) {
                its = std::uint32_t(vertices.size());
                vertices.push_back(v);
            }
            const Vec known = vertices[its];
            if (known.x == v.x && known.y == v.y && known.z == v.z) return its;
        }
    }

  private:
    static constexpr std::uint32_t kNone = ~0u;
    // Zeros of both signs are one place. Steele, Lea and Flood's mixer, coordinate by coordinate.
    static std::uint64_t hash(Vec v)
    {
        std::uint64_t z = 0;
        for (int k = 0; k < 3; ++k) {
            z += std::bit_cast<std::uint64_t>(v[k] + 0.0) + 0x9e3779b97f4a7c15ull;
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
            z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
            z ^= z >> 31;
        }
        return z;
    }
    std::vector<std::uint32_t> slots_;
};

// Three corners to a triangle. Those at the same place become one vertex, numbered as they first come; triangles with two
// such corners are left out.
void add_welded(const std::vector<Vec>& corners, Mesh& mesh)
{
    Places places(corners.size());
    for (size_t i = 0; i + 3 <= corners.size(); i += 3) {
        std::array<std::uint32_t, 3> t;
        for (size_t k = 0; k < 3; ++k) t[k] = places.number_of(corners[i + k], mesh.vertices);
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
