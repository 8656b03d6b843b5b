// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See asked_pairs.h.
#include "batch/model/asked_pairs.h"

#include <algorithm>

namespace epode::batch {

using namespace robots;

namespace {

struct Box {
    Vec middle, half;
    double radius;  // of the ball about its middle
};

Box about_points(const std::vector<Vec>& points)
{
    Vec low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
    for (const Vec p : points)
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    const Vec middle = 0.5 * (low + high);
    double radius = 0;
    for (const Vec p : points) radius = std::max(radius, length(p - middle));
    return {middle, 0.5 * (high - low), radius};
}

Box box_of(const Prepared& prepared, const AskedShape& its)
{
    const Shape& shape = *its.shape;
    const Vec s = shape.size;
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return {{}, {s.x, s.x, s.x}, s.x};
        case ShapeKind::kCapsule:
            return {{}, {s.x, s.x, s.x + s.y}, s.x + s.y};
        case ShapeKind::kCylinder:
            return {{}, {s.x, s.x, s.y}, std::sqrt(s.x * s.x + s.y * s.y)};
        case ShapeKind::kEllipsoid:
            return {{}, s, std::max({s.x, s.y, s.z})};
        case ShapeKind::kBox:
            return {{}, s, length(s)};
        case ShapeKind::kHull:
            return about_points(prepared.hulls(shape.mesh)[size_t(its.part)].corners());
        case ShapeKind::kTriangles:
            return about_points(prepared.model().meshes[size_t(shape.mesh)].vertices);
        case ShapeKind::kHeights: {
            const HeightField& field = prepared.model().fields[size_t(shape.field)];
            const double depth = std::fabs(field.base);
            const Vec half{field.half_x, field.half_y, 0.5 * (field.top + depth)};
            return {{0, 0, 0.5 * (field.top - depth)}, half, length(half)};
        }
        case ShapeKind::kPlane:
            break;
    }
    return {{}, {}, 0};
}

bool is_landscape(const Shape& shape)
{
    return shape.kind == ShapeKind::kHeights || shape.kind == ShapeKind::kTriangles;
}

}  // namespace

double AskedPairs::rank(const AskedShape& its) const
{
    if (its.shape->kind == ShapeKind::kPlane) return 3 * kInfinity;
    return is_landscape(*its.shape) ? kInfinity : box_of(*prepared, its).radius;
}

int AskedPairs::add(const AskedShape& a, const AskedShape& b)
{
    const auto place = [&](const AskedShape& its) {
        for (size_t i = 0; i < shapes.size(); ++i)
            if (shapes[i].number == its.number && shapes[i].part == its.part) return int(i);
        shapes.push_back(its);
        return int(shapes.size()) - 1;
    };
    AskedPair pair;
    pair.shape_a = place(a), pair.shape_b = place(b);
    pair.is_plane = b.shape->kind == ShapeKind::kPlane, pair.is_landscape = is_landscape(*b.shape);
    const Box one = box_of(*prepared, a), two = box_of(*prepared, b);
    pair.radius = one.radius;
    for (int k = 0; k < 3; ++k)
        pair.ball[k] = one.middle[k], pair.middle[k] = two.middle[k], pair.half[k] = two.half[k];
    pairs.push_back(pair);
    return int(pairs.size()) - 1;
}

int asked_points(const Shape& a, const Shape& b)
{
    const auto is = [&](ShapeKind kind) { return a.kind == kind || b.kind == kind; };
    if (is_landscape(a) || is_landscape(b)) return is(ShapeKind::kSphere) || is(ShapeKind::kCapsule) ? 4 : 8;
    if (is(ShapeKind::kSphere)) return 1;
    if (is(ShapeKind::kEllipsoid)) return 1;
    return is(ShapeKind::kCapsule) ? 2 : 4;
}

}  // namespace epode::batch
