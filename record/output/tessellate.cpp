// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Round shapes are one profile turned about z: points (r, z) with normals (n_r, n_z). Sphere and capsule
// share it, a capsule being a sphere whose halves were pulled apart. Flat shapes have a point for each corner
// of each triangle, with the triangle's normal.
#include "record/output/tessellate.h"

#include <cmath>

namespace epode::record {

namespace {

constexpr int kAround = 24;  // pieces of a full turn
constexpr int kRings = 6;    // pieces of a quarter turn

struct ProfilePoint {
    double r, z, normal_r, normal_z;
};

void add_point(Surface& surface, double x, double y, double z, double nx, double ny, double nz)
{
    surface.points.push_back({float(x), float(y), float(z)});
    surface.normals.push_back({float(nx), float(ny), float(nz)});
}

// Profile from below to above.
Surface turned(const std::vector<ProfilePoint>& profile)
{
    Surface surface;
    const auto rows = std::uint32_t(profile.size());
    for (int i = 0; i <= kAround; ++i) {
        const double angle = 2 * M_PI * (i % kAround) / kAround, c = std::cos(angle), s = std::sin(angle);
        for (const ProfilePoint& p : profile)
            add_point(surface, p.r * c, p.r * s, p.z, p.normal_r * c, p.normal_r * s, p.normal_z);
    }
    for (std::uint32_t i = 0; i < kAround; ++i) {
        for (std::uint32_t k = 0; k + 1 < rows; ++k) {
            const std::uint32_t a = i * rows + k, b = a + rows;
            if (profile[k].r > 0) surface.corners.insert(surface.corners.end(), {a, b, b + 1});
            if (profile[k + 1].r > 0) surface.corners.insert(surface.corners.end(), {a, b + 1, a + 1});
        }
    }
    return surface;
}

Surface capsule(double radius, double length)
{
    std::vector<ProfilePoint> profile;
    for (int half = -1; half <= 1; half += 2) {
        if (half == 1 && length == 0) profile.pop_back();
        for (int i = 0; i <= kRings; ++i) {
            const double tilt = M_PI / 2 * (half < 0 ? i - kRings : i) / kRings;
            const bool pole = half < 0 ? i == 0 : i == kRings;
            const double c = pole ? 0 : std::cos(tilt), s = std::sin(tilt);
            profile.push_back({radius * c, radius * s + half * length / 2, c, s});
        }
    }
    return turned(profile);
}

Surface cylinder(double radius, double length)
{
    const double h = length / 2;
    return turned({{0, -h, 0, -1},
                   {radius, -h, 0, -1},
                   {radius, -h, 1, 0},
                   {radius, h, 1, 0},
                   {radius, h, 0, 1},
                   {0, h, 0, 1}});
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// One with no area has no normal; it is left out.
void add_triangle(Surface& surface, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 n = cross(minus(b, a), minus(c, a));
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 1e-30)) return;
    for (const Vec3& p : {a, b, c}) {
        surface.corners.push_back(std::uint32_t(surface.points.size()));
        add_point(surface, p[0], p[1], p[2], n[0] / length, n[1] / length, n[2] / length);
    }
}

Surface triangles(const Shape& shape)
{
    Surface surface;
    for (const auto& t : shape.triangles)
        add_triangle(surface, shape.vertices[t[0]], shape.vertices[t[1]], shape.vertices[t[2]]);
    return surface;
}

void add_quad(Surface& surface, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    add_triangle(surface, a, b, c);
    add_triangle(surface, a, c, d);
}

Surface box(double x, double y, double z)
{
    Surface surface;
    const Vec3 half = {x / 2, y / 2, z / 2};
    for (size_t axis = 0; axis < 3; ++axis) {
        const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (double side : {-1.0, 1.0}) {
            const auto corner = [&](double su, double sv) {
                Vec3 p;
                p[axis] = side * half[axis];
                p[u] = su * side * half[u];
                p[v] = sv * half[v];
                return p;
            };
            add_quad(surface, corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
        }
    }
    return surface;
}

Surface plane(const std::array<double, 4>& p, double reach)
{
    const Vec3 n = {p[0], p[1], p[2]};
    // Any direction across the normal: the axis that lies least along it.
    const size_t least = std::abs(n[0]) <= std::abs(n[1]) && std::abs(n[0]) <= std::abs(n[2]) ? 0
                         : std::abs(n[1]) <= std::abs(n[2])                                   ? 1
                                                                                              : 2;
    Vec3 axis = {0, 0, 0};
    axis[least] = 1;
    Vec3 u = cross(axis, n);
    const double length = std::hypot(u[0], u[1], u[2]);
    Surface surface;
    if (!(length > 0)) return surface;
    for (double& value : u) value /= length;
    const Vec3 v = cross(n, u);
    const auto corner = [&](double su, double sv) {
        Vec3 out;
        for (size_t i = 0; i < 3; ++i) out[i] = n[i] * p[3] + reach * (su * u[i] + sv * v[i]);
        return out;
    };
    add_quad(surface, corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    return surface;
}

}  // namespace

Surface tessellate(const Shape& shape, double plane_reach)
{
    const auto& size = shape.size;
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return capsule(size[0], 0);
        case ShapeKind::kBox:
            return box(size[0], size[1], size[2]);
        case ShapeKind::kCapsule:
            return capsule(size[0], size[1]);
        case ShapeKind::kCylinder:
            return cylinder(size[0], size[1]);
        case ShapeKind::kPlane:
            return plane(size, plane_reach);
        case ShapeKind::kConvex:
        case ShapeKind::kMesh:
        case ShapeKind::kHeightField:
            return triangles(shape);
        default:
            return {};
    }
}

}  // namespace epode::record
