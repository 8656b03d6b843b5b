// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The state of drawing and the floor's pyramids. Triangles get the normal of their plane; one whose corners
// lie on a line has none and is left out.
#include "draw_list.h"

#include <algorithm>

namespace epode::drawstuff {

namespace {

constexpr float kPyramidHalf = 0.03f, kPyramidHeight = 0.06f;
constexpr int kMaxQuality = 15;

}  // namespace

DrawList& draw_list()
{
    static DrawList list;
    return list;
}

void DrawList::begin_frame()
{
    picture_.shapes.clear();
    picture_.triangles.clear();
    picture_.lines.clear();
    const bool wire = wire_;
    wire_ = false;
    alpha_ = 1;
    texture_ = viewer::Texture::kNone;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            color_ = x == 1 && y == 0   ? viewer::Color{1, 0, 0}
                     : x == 0 && y == 1 ? viewer::Color{0, 0, 1}
                                        : viewer::Color{1, 1, 0};
            add_pyramid(static_cast<float>(x), static_cast<float>(y));
        }
    }
    color_ = {1, 1, 1};
    wire_ = wire;
}

void DrawList::add_pyramid(float x, float y)
{
    const float k = kPyramidHalf;
    const float base[4][3] = {{x - k, y - k, 0}, {x + k, y - k, 0}, {x + k, y + k, 0}, {x - k, y + k, 0}};
    const float top[3] = {x, y, kPyramidHeight};
    for (int i = 0; i < 4; ++i) {
        float side[3][3];
        std::copy(base[i], base[i] + 3, side[0]);
        std::copy(base[(i + 1) % 4], base[(i + 1) % 4] + 3, side[1]);
        std::copy(top, top + 3, side[2]);
        add_triangle(side, side);
    }
}

void DrawList::set_color(float r, float g, float b, float alpha)
{
    if (!std::isfinite(r + g + b + alpha)) return;
    const auto unit = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    color_ = {unit(r), unit(g), unit(b)};
    alpha_ = unit(alpha);
}

void DrawList::set_texture(int number)
{
    texture_ = number >= 0 && number <= 4 ? static_cast<viewer::Texture>(number) : viewer::Texture::kNone;
}

void DrawList::set_sphere_quality(int n)
{
    if (n > 0) sphere_quality_ = std::min(n, kMaxQuality);
}

void DrawList::set_capsule_quality(int n)
{
    if (n > 0) capsule_quality_ = std::min(n, kMaxQuality);
}

viewer::Shape DrawList::styled(viewer::ShapeKind kind) const
{
    viewer::Shape shape;
    shape.kind = kind;
    shape.color = color_;
    shape.alpha = alpha_;
    shape.texture = texture_;
    shape.wire = wire_;
    // Surfaces are round at any quality; wires are distinguished only if there are few.
    if (kind == viewer::ShapeKind::kSphere)
        shape.steps = wire_ ? 1 + sphere_quality_ : 3 + 3 * sphere_quality_;
    if (kind == viewer::ShapeKind::kCapsule)
        shape.steps = wire_ ? capsule_quality_ : 2 + 2 * capsule_quality_;
    return shape;
}

void DrawList::add_triangle(const float (&world)[3][3], const float (&local)[3][3])
{
    float u[3], v[3];
    for (int i = 0; i < 3; ++i) {
        u[i] = world[1][i] - world[0][i];
        v[i] = world[2][i] - world[0][i];
    }
    const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0) || !std::isfinite(length)) return;
    viewer::Triangle triangle;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            triangle.corners[k].pos[i] = world[k][i];
            triangle.corners[k].normal[i] = n[i] / length;
            triangle.corners[k].local[i] = local[k][i];
        }
    }
    triangle.color = color_;
    triangle.alpha = alpha_;
    triangle.texture = texture_;
    triangle.wire = wire_;
    picture_.triangles.push_back(triangle);
}

}  // namespace epode::drawstuff
