// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See zone.h. On a ray p + t d a zone is where t is in an interval of each of its parts: of a slab |x| <= h, of a round one where a
// quadratic a t^2 + 2 b t + c is at most 0.
#include "robots/zone.h"

#include <algorithm>
#include <cmath>

namespace epode::robots {

namespace {

struct Span {
    double low, high;
    bool is_ahead() const { return high >= std::max(low, 0.0); }
};

Span both(Span a, Span b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

Span slab(double p, double d, double half)
{
    if (d == 0) return std::fabs(p) <= half ? Span{-kInfinity, kInfinity} : Span{1, 0};
    const double one = (-half - p) / d, two = (half - p) / d;
    return {std::min(one, two), std::max(one, two)};
}

Span round(double a, double b, double c)
{
    if (!(a > 0)) return c <= 0 ? Span{-kInfinity, kInfinity} : Span{1, 0};
    const double root = b * b - a * c;
    if (root < 0) return {1, 0};
    return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

Span ball(Vec p, Vec d, double radius) { return round(dot(d, d), dot(p, d), dot(p, p) - radius * radius); }

Span tube(Vec p, Vec d, double radius, double half)
{
    const Span side =
        round(d.x * d.x + d.y * d.y, p.x * d.x + p.y * d.y, p.x * p.x + p.y * p.y - radius * radius);
    return both(side, slab(p.z, d.z, half));
}

}  // namespace

bool ray_meets_zone(ShapeKind kind, Vec size, Vec p, Vec d)
{
    const Vec end{0, 0, size.y};
    switch (kind) {
        case ShapeKind::kSphere:
            return ball(p, d, size.x).is_ahead();
        case ShapeKind::kEllipsoid:
            return ball({p.x / size.x, p.y / size.y, p.z / size.z},
                        {d.x / size.x, d.y / size.y, d.z / size.z}, 1)
                .is_ahead();
        case ShapeKind::kBox:
            return both(both(slab(p.x, d.x, size.x), slab(p.y, d.y, size.y)), slab(p.z, d.z, size.z))
                .is_ahead();
        case ShapeKind::kCylinder:
            return tube(p, d, size.x, size.y).is_ahead();
        case ShapeKind::kCapsule:
            return tube(p, d, size.x, size.y).is_ahead() || ball(p - end, d, size.x).is_ahead() ||
                   ball(p + end, d, size.x).is_ahead();
        default:
            return true;
    }
}

bool is_in_zone(ShapeKind kind, Vec size, Vec p)
{
    const double across = p.x * p.x + p.y * p.y, end = std::max(0.0, std::fabs(p.z) - size.y);
    switch (kind) {
        case ShapeKind::kEllipsoid:
            p = {p.x / size.x, p.y / size.y, p.z / size.z};
            return dot(p, p) <= 1;
        case ShapeKind::kBox:
            return std::fabs(p.x) <= size.x && std::fabs(p.y) <= size.y && std::fabs(p.z) <= size.z;
        case ShapeKind::kCylinder:
            return across <= size.x * size.x && end == 0;
        case ShapeKind::kCapsule:
            return across + end * end <= size.x * size.x;
        default:
            return dot(p, p) <= size.x * size.x;
    }
}

}  // namespace epode::robots
