// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See inertia.h. A capsule is a cylinder (mass m_c, length l) and two half balls (m_s together): about its middle
//     I_z = m_c r^2/2 + 2/5 m_s r^2,   I_x = m_c (r^2/4 + l^2/12) + m_s (2/5 r^2 + l^2/4 + 3/8 l r).
#include "robots/inertia.h"

#include <algorithm>
#include <numbers>

#include "robots/meshes/solid.h"
#include "robots/numbers.h"

namespace epode::robots {

namespace {

Matrix diagonal(double x, double y, double z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }

Inertia box(Vec h)
{
    const double m = 8 * h.x * h.y * h.z;
    return {m,
            {},
            diagonal(m / 3 * (h.y * h.y + h.z * h.z), m / 3 * (h.x * h.x + h.z * h.z),
                     m / 3 * (h.x * h.x + h.y * h.y))};
}

Inertia ellipsoid(Vec r)
{
    const double m = 4 * std::numbers::pi / 3 * r.x * r.y * r.z;
    return {m,
            {},
            diagonal(m / 5 * (r.y * r.y + r.z * r.z), m / 5 * (r.x * r.x + r.z * r.z),
                     m / 5 * (r.x * r.x + r.y * r.y))};
}

Inertia cylinder(double r, double half)
{
    const double m = std::numbers::pi * r * r * 2 * half, side = m * (r * r / 4 + half * half / 3);
    return {m, {}, diagonal(side, side, m * r * r / 2)};
}

Inertia capsule(double r, double half)
{
    const Inertia shaft = cylinder(r, half);
    const double ball = 4 * std::numbers::pi / 3 * r * r * r, l = 2 * half;
    const double side = shaft.tensor[0][0] + ball * (0.4 * r * r + l * l / 4 + 0.375 * l * r);
    return {shaft.mass + ball, {}, diagonal(side, side, shaft.tensor[2][2] + 0.4 * ball * r * r)};
}

// Second moments of an area of that size about the origin become inertias: I = tr(M) 1 - M.
Inertia shell(double area, Vec moments)
{
    return {area, {}, diagonal(moments.y + moments.z, moments.x + moments.z, moments.x + moments.y)};
}

Inertia box_shell(Vec h)
{
    const Vec faces{8 * h.y * h.z, 8 * h.x * h.z, 8 * h.x * h.y};  // pairs of them
    const double area = faces.x + faces.y + faces.z;
    return shell(area, {h.x * h.x / 3 * (area + 2 * faces.x), h.y * h.y / 3 * (area + 2 * faces.y),
                        h.z * h.z / 3 * (area + 2 * faces.z)});
}

Inertia cylinder_shell(double r, double half)
{
    const double side = 4 * std::numbers::pi * r * half, ends = 2 * std::numbers::pi * r * r;
    const double across = side * r * r / 2 + ends * r * r / 4;
    return shell(side + ends, {across, across, half * half * (side / 3 + ends)});
}

// Half a spherical shell has its centre at r/2, and r^2/3 as its mean square of each coordinate.
Inertia capsule_shell(double r, double half)
{
    const double side = 4 * std::numbers::pi * r * half, ball = 4 * std::numbers::pi * r * r;
    const double across = side * r * r / 2 + ball * r * r / 3;
    return shell(side + ball,
                 {across, across, side * half * half / 3 + ball * (r * r / 3 + half * r + half * half)});
}

// What lies between the ellipsoids r and r + e, e -> 0, with the mass of the area.
Inertia ellipsoid_shell(Vec r)
{
    constexpr double kThomsen = 1.6075;
    const auto power = [](double x) { return std::pow(x, kThomsen); };
    const double area = 4 * std::numbers::pi *
                        std::pow((power(r.x * r.y) + power(r.x * r.z) + power(r.y * r.z)) / 3, 1 / kThomsen);
    const double grown = 1 / r.x + 1 / r.y + 1 / r.z;
    const auto moment = [&](double its) { return area / 5 * its * (its + 2 / grown); };
    return shell(area, {moment(r.x), moment(r.y), moment(r.z)});
}

// A triangle of area A with the corners r_i from its centre has the second moments A/12 sum_i r_i r_i^T.
Inertia mesh_shell(const Mesh& mesh)
{
    Inertia out;
    for (const auto& t : mesh.triangles) {
        const Vec a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        const double area = length(cross(b - a, c - a)) / 2;
        Inertia one{area, (1.0 / 3) * (a + b + c), {}};
        for (const Vec& corner : {a, b, c})
            one.tensor = one.tensor + point_inertia(area / 12, corner - one.centre);
        out = sum_of(out, one);
    }
    return out;
}

Inertia shell_in_its_frame(const Shape& shape, const std::vector<Mesh>& meshes)
{
    const Vec s = shape.size;
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return ellipsoid_shell({s.x, s.x, s.x});
        case ShapeKind::kBox:
            return box_shell(s);
        case ShapeKind::kEllipsoid:
            return ellipsoid_shell(s);
        case ShapeKind::kCylinder:
            return cylinder_shell(s.x, s.y);
        case ShapeKind::kCapsule:
            return capsule_shell(s.x, s.y);
        case ShapeKind::kHull:
        case ShapeKind::kTriangles:
            return shape.mesh >= 0 ? mesh_shell(meshes[size_t(shape.mesh)]) : Inertia{};
        case ShapeKind::kPlane:
        case ShapeKind::kHeights:
            return {};
    }
    return {};
}

Inertia in_its_frame(const Shape& shape, const std::vector<Mesh>& meshes)
{
    const Vec s = shape.size;
    Solid solid;
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return ellipsoid({s.x, s.x, s.x});
        case ShapeKind::kBox:
            return box(s);
        case ShapeKind::kEllipsoid:
            return ellipsoid(s);
        case ShapeKind::kCylinder:
            return cylinder(s.x, s.y);
        case ShapeKind::kCapsule:
            return capsule(s.x, s.y);
        case ShapeKind::kHull:
        case ShapeKind::kTriangles:
            if (shape.mesh >= 0 && solid_of(meshes[size_t(shape.mesh)], solid))
                return {solid.volume, solid.centre, solid.inertia};
            return {};
        case ShapeKind::kPlane:
        case ShapeKind::kHeights:
            return {};
    }
    return {};
}

Matrix scaled_by(Matrix m, double factor)
{
    for (auto& row : m)
        for (double& value : row) value *= factor;
    return m;
}

}  // namespace

Inertia moved(const Inertia& inertia, const Pose& pose)
{
    return {inertia.mass, pose * inertia.centre, rotated(inertia.tensor, pose.q), pose.q * inertia.axes};
}

Inertia inertia_of(const Shape& shape, const std::vector<Mesh>& meshes)
{
    return moved(in_its_frame(shape, meshes), shape.pose);
}

Inertia shell_of(const Shape& shape, const std::vector<Mesh>& meshes)
{
    return moved(shell_in_its_frame(shape, meshes), shape.pose);
}

Inertia with_mass(Inertia inertia, double mass)
{
    if (!(inertia.mass > 0)) return {};
    inertia.tensor = scaled_by(inertia.tensor, mass / inertia.mass);
    inertia.mass = mass;
    return inertia;
}

Inertia sum_of(const Inertia& a, const Inertia& b)
{
    if (!(a.mass + b.mass > 0)) return {0, {}, a.tensor + b.tensor};
    Inertia out;
    out.mass = a.mass + b.mass;
    out.axes = a.mass == 0 ? b.axes : b.mass == 0 ? a.axes : Quat{};
    out.centre = (1 / out.mass) * (a.mass * a.centre + b.mass * b.centre);
    out.tensor = a.tensor + b.tensor + point_inertia(a.mass, a.centre - out.centre) +
                 point_inertia(b.mass, b.centre - out.centre);
    return out;
}

std::string fault_of(const Matrix& inertia)
{
    if (!is_finite(inertia)) return "is not finite";
    const auto m = principal_moments(inertia);
    const std::string values =
        "(principal moments " + text_of(m[0]) + ", " + text_of(m[1]) + ", " + text_of(m[2]) + " kg m^2)";
    if (!(m[0] > 0)) return "is not positive definite " + values;
    if (m[2] > m[0] + m[1] + 1e-9 * (m[0] + m[1] + m[2]))
        return "has a moment larger than the sum of the others " + values + ", which no body has";
    return {};
}

// Adding s to the diagonal adds s to each moment: enough that the least is positive and the triangle holds.
Matrix mended(const Matrix& inertia, double mass)
{
    if (!is_finite(inertia)) return diagonal(1e-3 * mass, 1e-3 * mass, 1e-3 * mass);
    Matrix symmetric = scaled_by(inertia + transposed(inertia), 0.5);
    const auto m = principal_moments(symmetric);
    const double least = std::max(1e-6 * m[2], 1e-9 * mass);
    const double rise = std::max({0.0, least - m[0], m[2] - m[0] - m[1]});
    return symmetric + diagonal(rise, rise, rise);
}

}  // namespace epode::robots
