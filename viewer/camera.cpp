// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cameras: fitting one to shapes, its matrix, projection.
// Fitting: looking direction fixed, balls (c_i, r_i) given, which eye is nearest? In view axes let u, v, w =
// c_i along right, up, back. With t = tan(half opening) and r' = r_i / cos(half opening), a ball at depth D -
// w lies inside the right plane when u + r' - tx <= t (D - w) and inside the left when -u + r' + tx <= t (D -
// w). With A = max(u + r' + t w), B = max(-u + r' + t w) a shift tx exists iff D >= (A + B) / 2t, and tx = (A
// - B) / 2 centres it. The same vertically; the larger D wins. Exact and without a loop, where the usual
// sphere around everything wastes half of a wide picture.
#include "camera.h"

#include <algorithm>

namespace epode::viewer {

namespace {

constexpr float kDegree = 3.14159265f / 180;
constexpr float kMargin = 1.12f;  // of the exact fit's opening: air around the subject

// One pair of opposite planes of the view's pyramid.
struct Slab {
    float tangent, secant;
    float high = -1e30f, low = -1e30f;

    explicit Slab(float half_tangent)
        : tangent(half_tangent), secant(std::sqrt(1 + half_tangent * half_tangent))
    {}
    void add(float across, float back, float radius)
    {
        high = std::max(high, across + secant * radius + tangent * back);
        low = std::max(low, -across + secant * radius + tangent * back);
    }
    float distance() const { return (high + low) / (2 * tangent); }
    float shift() const { return (high - low) / 2; }
};

}  // namespace

bool drawable(const Shape& shape)
{
    const int used = shape.kind == ShapeKind::kSphere ? 1 : shape.kind == ShapeKind::kBox ? 3 : 2;
    for (int i = 0; i < used; ++i) {
        const bool may_be_zero = shape.kind == ShapeKind::kCapsule && i == 1;
        if (!(shape.size[i] > 0 || (may_be_zero && shape.size[i] == 0)) || !(shape.size[i] < 1e15f))
            return false;
    }
    for (int i = 0; i < 12; ++i) {
        if (i % 4 != 3 && !(std::fabs(shape.rot[i]) < 2)) return false;
    }
    return std::all_of(shape.pos, shape.pos + 3, [](float x) { return std::fabs(x) < 1e15f; });
}

bool drawable(const Triangle& triangle)
{
    return std::all_of(triangle.corners, triangle.corners + 3, [](const Corner& corner) {
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(corner.pos[i]) < 1e15f) || !(std::fabs(corner.normal[i]) < 2) ||
                !(std::fabs(corner.local[i]) < 1e15f))
                return false;
        }
        return true;
    });
}

Ball bounding_ball(const Shape& shape)
{
    const float* s = shape.size;
    float radius = s[0];
    if (shape.kind == ShapeKind::kBox) radius = 0.5f * length({s[0], s[1], s[2]});
    if (shape.kind == ShapeKind::kCapsule) radius = s[0] + 0.5f * s[1];
    if (shape.kind == ShapeKind::kCylinder) radius = length({s[0], 0.5f * s[1], 0});
    return {vec(shape.pos), radius};
}

void Bounds::add(Vec p, float radius)
{
    lo = {std::min(lo.x, p.x - radius), std::min(lo.y, p.y - radius), std::min(lo.z, p.z - radius)};
    hi = {std::max(hi.x, p.x + radius), std::max(hi.y, p.y + radius), std::max(hi.z, p.z + radius)};
}

Camera frame_shapes(std::span<const Shape> shapes, float aspect, float azimuth, float elevation)
{
    Camera camera;
    const float a = azimuth * kDegree, e = elevation * kDegree;
    const Basis basis =
        look_along({std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e)}, {0, 0, 1});
    const float tangent = std::tan(0.5f * camera.fov * kDegree) / kMargin;
    Slab across(tangent * std::max(aspect, 0.1f)), upward(tangent);
    Bounds bounds;
    for (const Shape& shape : shapes) {
        if (!drawable(shape)) continue;
        const Ball ball = bounding_ball(shape);
        const float back = dot(ball.center, basis.back);
        across.add(dot(ball.center, basis.right), back, ball.radius);
        upward.add(dot(ball.center, basis.up), back, ball.radius);
        bounds.add(ball.center, 0);
    }
    if (bounds.empty()) return camera;
    const float far = std::max(across.distance(), upward.distance());
    const Vec eye = across.shift() * basis.right + upward.shift() * basis.up + far * basis.back;
    const float depth = std::max(far - dot(0.5f * (bounds.lo + bounds.hi), basis.back), 1e-3f);
    const Vec target = eye - depth * basis.back;
    for (int i = 0; i < 3; ++i) {
        camera.eye[i] = (&eye.x)[i];
        camera.target[i] = (&target.x)[i];
    }
    return camera;
}

float view_distance(const Camera& camera) { return length(vec(camera.eye) - vec(camera.target)); }

bool valid(const Camera& camera)
{
    const float d = view_distance(camera);
    return finite(vec(camera.eye)) && finite(vec(camera.up)) && std::isfinite(camera.shift[0]) &&
           std::isfinite(camera.shift[1]) && d > 1e-6f && d < 1e15f && camera.fov > 1 && camera.fov < 170;
}

Mat4 camera_matrix(const Camera& camera, float aspect)
{
    const Vec eye = vec(camera.eye);
    const Basis basis = look_along(eye - vec(camera.target), vec(camera.up));
    const float d = view_distance(camera);
    Mat4 lens = perspective(camera.fov, aspect, 0.02f * d, 400 * d);
    for (int i = 0; i < 2; ++i) lens.m[8 + i] = -camera.shift[i];
    return lens * view_matrix(basis, eye);
}

bool project(const Camera& camera, int width, int height, const float point[3], float pixel[2])
{
    const Mat4 matrix = camera_matrix(camera, static_cast<float>(width) / static_cast<float>(height));
    float clip[4];
    for (int i = 0; i < 4; ++i) {
        clip[i] = matrix.m[i] * point[0] + matrix.m[4 + i] * point[1] + matrix.m[8 + i] * point[2] +
                  matrix.m[12 + i];
    }
    if (!(clip[3] > 0)) return false;
    pixel[0] = (0.5f + 0.5f * clip[0] / clip[3]) * static_cast<float>(width);
    pixel[1] = (0.5f - 0.5f * clip[1] / clip[3]) * static_cast<float>(height);
    return true;
}

}  // namespace epode::viewer
