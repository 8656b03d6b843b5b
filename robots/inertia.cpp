// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See inertia.h. A capsule is a cylinder (mass m_c, length l) and two half balls (m_s together): about its middle
//     I_z = m_c r^2/2 + 2/5 m_s r^2,   I_x = m_c (r^2/4 + l^2/12) + m_s (2/5 r^2 + l^2/4 + 3/8 l r).
#include "robots/inertia.h"

#include <algorithm>
#include <numbers>

#include "robots/meshes/solid.h"

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
    const std::string values = "(principal moments " + std::to_string(m[0]) + ", " + std::to_string(m[1]) +
                               ", " + std::to_string(m[2]) + " kg m^2)";
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
