// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Building the two meshes of meshes.h, and the instance that fits one of them to a shape.
// Rounded box: each of the six faces is a grid whose lines carry (corner sign, tilt a); n = normalize(axis +
// tan(a_u) u + tan(a_v) v), tilts run from -45 to 45 degrees, so the six grids meet in the edges' middle and
// together cover the ball. With a core of size zero the same mesh is a sphere without poles. Rounded
// cylinder: a profile of (ring, end, tilt) turned about z.
#include "meshes.h"

#include <algorithm>
#include <cmath>

namespace epode::viewer {

namespace {

constexpr float kPi = 3.14159265f;
constexpr float kBevel =
    0.035f;  // of a box's or cylinder's smallest size: seen as an edge that shines, not as a changed shape

struct GridLine {
    float corner, slope;
};

std::vector<GridLine> grid_lines(int steps)
{
    std::vector<GridLine> lines;
    for (int i = -steps; i <= 0; ++i)
        lines.push_back({-1, std::tan(kPi / 4 * static_cast<float>(i) / static_cast<float>(steps))});
    for (int i = 0; i <= steps; ++i)
        lines.push_back({1, std::tan(kPi / 4 * static_cast<float>(i) / static_cast<float>(steps))});
    return lines;
}

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    for (const std::uint32_t i : {a, b, c, a, c, d}) mesh.indices.push_back(i);
}

// Grid of (rows x columns) vertices whose first one is at `base`; (row, column) run counter-clockwise when
// not flipped.
void add_grid(Mesh& mesh, std::uint32_t base, std::uint32_t rows, std::uint32_t columns, bool flipped)
{
    for (std::uint32_t i = 0; i + 1 < rows; ++i) {
        for (std::uint32_t j = 0; j + 1 < columns; ++j) {
            const std::uint32_t a = base + i * columns + j, b = a + columns;
            if (flipped) {
                add_quad(mesh, a, a + 1, b + 1, b);
            } else {
                add_quad(mesh, a, b, b + 1, a + 1);
            }
        }
    }
}

void add_face(Mesh& mesh, int axis, float side, const std::vector<GridLine>& lines)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const GridLine& along_u : lines) {
        for (const GridLine& along_v : lines) {
            const float n = 1 / std::sqrt(1 + along_u.slope * along_u.slope + along_v.slope * along_v.slope);
            Vertex vertex{};
            vertex.corner[axis] = side;
            vertex.corner[u] = along_u.corner;
            vertex.corner[v] = along_v.corner;
            vertex.normal[axis] = side * n;
            vertex.normal[u] = along_u.slope * n;
            vertex.normal[v] = along_v.slope * n;
            mesh.vertices.push_back(vertex);
        }
    }
    const auto count = static_cast<std::uint32_t>(lines.size());
    add_grid(mesh, base, count, count, side < 0);
}

struct ProfilePoint {
    float ring, end, tilt;
};

std::vector<ProfilePoint> cylinder_profile(int steps)
{
    std::vector<ProfilePoint> profile = {{0, -1, -kPi / 2}};
    for (int i = 0; i <= steps; ++i)
        profile.push_back({1, -1, -kPi / 2 * static_cast<float>(steps - i) / static_cast<float>(steps)});
    for (int i = 0; i <= steps; ++i)
        profile.push_back({1, 1, kPi / 2 * static_cast<float>(i) / static_cast<float>(steps)});
    profile.push_back({0, 1, kPi / 2});
    return profile;
}

}  // namespace

Mesh rounded_box(int steps)
{
    Mesh mesh;
    const std::vector<GridLine> lines = grid_lines(steps);
    for (int axis = 0; axis < 3; ++axis) {
        add_face(mesh, axis, 1, lines);
        add_face(mesh, axis, -1, lines);
    }
    return mesh;
}

Mesh rounded_cylinder(int sides, int steps)
{
    Mesh mesh;
    const std::vector<ProfilePoint> profile = cylinder_profile(steps);
    for (int i = 0; i <= sides; ++i) {
        const float turn = 2 * kPi * static_cast<float>(i % sides) / static_cast<float>(sides);
        const float c = std::cos(turn), s = std::sin(turn);
        for (const ProfilePoint& p : profile) {
            const float out = std::cos(p.tilt), up = std::sin(p.tilt);
            mesh.vertices.push_back({{p.ring * c, p.ring * s, p.end}, {out * c, out * s, up}});
        }
    }
    add_grid(mesh, 0, static_cast<std::uint32_t>(sides) + 1, static_cast<std::uint32_t>(profile.size()),
             false);
    return mesh;
}

Instance instance_of(const Shape& shape)
{
    Instance instance{};
    for (int i = 0; i < 3; ++i) {
        std::copy(shape.rot + 4 * i, shape.rot + 4 * i + 3, instance.row[i]);
        instance.row[i][3] = shape.pos[i];
    }
    const float* s = shape.size;
    float half[3] = {0, 0, 0};
    float radius = s[0];
    if (shape.kind == ShapeKind::kCapsule) half[2] = s[1] / 2;
    if (shape.kind == ShapeKind::kBox) {
        radius = kBevel * std::min({s[0], s[1], s[2]});
        for (int i = 0; i < 3; ++i) half[i] = s[i] / 2 - radius;
    }
    if (shape.kind == ShapeKind::kCylinder) {
        radius = kBevel * std::min(2 * s[0], s[1]);
        half[0] = half[1] = s[0] - radius;
        half[2] = s[1] / 2 - radius;
    }
    std::copy(half, half + 3, instance.core);
    instance.core[3] = radius;
    instance.color[0] = shape.color.r;
    instance.color[1] = shape.color.g;
    instance.color[2] = shape.color.b;
    instance.color[3] = shape.alpha;
    instance.texture = static_cast<float>(shape.texture);
    return instance;
}

}  // namespace epode::viewer
