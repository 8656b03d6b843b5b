// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See overlap.h.
#include "bench/measure/overlap.h"

#include <algorithm>
#include <cmath>

namespace epode::bench {

namespace {

using scenes::kX;
using scenes::kY;
using scenes::kZ;

Vec local_support(const ShapeData& shape, Vec d)
{
    const double r = shape.size.x, half = shape.size.y / 2, size = length(d);
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return (r / size) * d;
        case ShapeKind::kBox:
            return 0.5 * Vec{std::copysign(shape.size.x, d.x), std::copysign(shape.size.y, d.y),
                             std::copysign(shape.size.z, d.z)};
        case ShapeKind::kCapsule:
            return (r / size) * d + Vec{0, 0, std::copysign(half, d.z)};
        case ShapeKind::kCylinder: {
            const double across = std::hypot(d.x, d.y), scale = across > 1e-12 * size ? r / across : 0;
            return {scale * d.x, scale * d.y, std::copysign(half, d.z)};
        }
        case ShapeKind::kHull:
        case ShapeKind::kMesh:
            break;
    }
    const auto less = [&](Vec a, Vec b) { return dot(a, d) < dot(b, d); };
    return *std::max_element(shape.points.begin(), shape.points.end(), less);
}

// Normals of flat faces, one of each opposite pair where there are such pairs.
std::vector<Vec> face_normals(const Placed& p)
{
    std::vector<Vec> normals;
    if (p.shape->kind == ShapeKind::kBox) normals = {kX, kY, kZ};
    if (p.shape->kind == ShapeKind::kCylinder) normals = {kZ};
    for (const auto& face : p.shape->triangles) {
        const auto corner = [&](int i) { return p.shape->points[size_t(face[size_t(i)])]; };
        normals.push_back(cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    for (Vec& n : normals) n = rotate(p.turn, n);
    return normals;
}

class Least {
  public:
    Least(const Placed& a, const Placed& b) : a_(a), b_(b) {}

    double f(Vec d) const { return dot(support(a_, d) - support(b_, -1 * d), d); }

    void try_direction(Vec d)
    {
        const double size = length(d);
        if (size < 1e-9) return;
        for (double sign : {1.0, -1.0}) {
            const Vec unit = (sign / size) * d;
            const double value = f(unit);
            if (value < best) {
                best = value;
                direction = unit;
            }
        }
    }

    void improve()
    {
        for (double step = 0.2; step > 1e-5 && best > 0;) {
            const double before = best;
            const Vec at = direction, side = std::abs(at.x) < 0.6 ? cross(at, kX) : cross(at, kY);
            const Vec u = (1 / length(side)) * side, v = cross(at, u);
            for (Vec move : {u, -1 * u, v, -1 * v}) try_direction(at + step * move);
            if (best >= before) step /= 2;
        }
    }

    double best = 1e300;
    Vec direction;

  private:
    const Placed &a_, &b_;
};

}  // namespace

Vec support(const Placed& p, Vec d)
{
    return p.pos + rotate(p.turn, local_support(*p.shape, rotate(inverse(p.turn), d)));
}

double overlap(const Placed& a, const Placed& b)
{
    Least least(a, b);
    const std::vector<Vec> of_a = face_normals(a), of_b = face_normals(b);
    least.try_direction(b.pos - a.pos);
    for (Vec n : of_a) least.try_direction(n);
    for (Vec n : of_b) least.try_direction(n);
    const bool boxes = a.shape->kind == ShapeKind::kBox && b.shape->kind == ShapeKind::kBox;
    if (boxes) {
        for (Vec m : of_a) {
            for (Vec n : of_b) least.try_direction(cross(m, n));
        }
    } else {
        least.improve();
    }
    return least.best;
}

double overlap(const Placed& placed, const Terrain& terrain)
{
    double worst = -1e300;
    for (int n = 0; n < 27; ++n) {
        const Vec d{n % 3 - 1.0, n / 3 % 3 - 1.0, n / 9 - 1.0};
        if (dot(d, d) == 0) continue;
        const Vec point = support(placed, d);
        Vec normal;
        const double height = terrain.at(point.x, point.y, &normal);
        worst = std::max(worst, (height - point.z) * normal.z);
    }
    return worst;
}

Bounds bounds(const Placed& p)
{
    return {{support(p, -1 * kX).x, support(p, -1 * kY).y, support(p, -1 * kZ).z},
            {support(p, kX).x, support(p, kY).y, support(p, kZ).z}};
}

}  // namespace epode::bench
