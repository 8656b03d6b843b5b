// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// OBJ: the lines "v x y z" and "f a b c ...", all others left out. A corner is "7", "7/2" or "7//3", of which the first
// number counts: from 1, or from the last vertex backwards if it is negative. Faces of more than three corners become
// fans: of a hull and of the volume that a mesh encloses the result is that of any other division, so that a library
// would add nothing.
#include <charconv>

#include "robots/meshes/formats.h"
#include "robots/meshes/words.h"

namespace epode::robots {

namespace {

bool read_corner(std::string_view corner, size_t vertices, std::uint32_t& index)
{
    long n = 0;
    std::from_chars(corner.data(), corner.data() + corner.size(), n);
    const long count = long(vertices);
    if (n == 0 || n > count || n < -count) return false;
    index = std::uint32_t(n > 0 ? n - 1 : count + n);
    return true;
}

bool read_face(std::string_view line, Mesh& mesh)
{
    Words words(line);
    std::vector<std::uint32_t> face;
    for (std::string_view corner; words.next(corner);)
        if (!read_corner(corner, mesh.vertices.size(), face.emplace_back())) return false;
    if (mesh.triangles.size() + face.size() > kMaxTriangles) return false;
    for (size_t i = 2; i < face.size(); ++i) mesh.triangles.push_back({face[0], face[i - 1], face[i]});
    return true;
}

}  // namespace

bool read_obj(const std::string&, const std::string& text, Mesh& mesh, std::string&)
{
    Words words(text);
    for (std::string_view word; words.next(word);) {
        if (word == "v") {
            if (!words.vec(mesh.vertices.emplace_back())) return false;
        } else {
            const std::string_view line = words.line();
            if (word == "f" && !read_face(line, mesh)) return false;
        }
    }
    return true;
}

}  // namespace epode::robots
