// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Integrals over a solid are sums over the tetrahedra from the origin to its faces: with corners a, b, c and
// det = a.(b x c), the volume is det/6 and the integral of x^2 is det/60 (ax^2 + bx^2 + cx^2 + ax bx + bx cx
// + cx ax).
#include "bench/scenes/hull.h"

#include <algorithm>
#include <cmath>

namespace epode::bench {

namespace {

// +1: all other points behind the face a b c, -1: all before it, 0: neither.
int side_of_all(const std::vector<Vec>& points, int a, int b, int c)
{
    const Vec origin = points[size_t(a)];
    const Vec normal = cross(points[size_t(b)] - origin, points[size_t(c)] - origin);
    bool before = false, behind = false;
    for (int k = 0; k < int(points.size()); ++k) {
        if (k == a || k == b || k == c) continue;
        (dot(normal, points[size_t(k)] - origin) > 0 ? before : behind) = true;
    }
    return before == behind ? 0 : behind ? 1 : -1;
}

std::vector<std::array<int, 3>> hull_faces(const std::vector<Vec>& points)
{
    std::vector<std::array<int, 3>> faces;
    const int n = int(points.size());
    for (int a = 0; a < n; ++a) {
        for (int b = a + 1; b < n; ++b) {
            for (int c = b + 1; c < n; ++c) {
                const int side = side_of_all(points, a, b, c);
                if (side > 0) faces.push_back({a, b, c});
                if (side < 0) faces.push_back({a, c, b});
            }
        }
    }
    return faces;
}

void drop_inner_points(ShapeData& hull)
{
    std::vector<int> number(hull.points.size(), -1);
    std::vector<Vec> kept;
    for (auto& face : hull.triangles) {
        for (int& corner : face) {
            int& n = number[size_t(corner)];
            if (n < 0) {
                n = int(kept.size());
                kept.push_back(hull.points[size_t(corner)]);
            }
            corner = n;
        }
    }
    hull.points = kept;
}

double square_sum(double a, double b, double c) { return a * a + b * b + c * c + a * b + b * c + c * a; }

}  // namespace

Solid integrate(const ShapeData& hull)
{
    Solid solid;
    for (const auto& face : hull.triangles) {
        const Vec a = hull.points[size_t(face[0])], b = hull.points[size_t(face[1])],
                  c = hull.points[size_t(face[2])];
        const double det = dot(a, cross(b, c));
        solid.volume += det / 6;
        solid.centre = solid.centre + (det / 24) * (a + b + c);
        solid.second = solid.second + (det / 60) * Vec{square_sum(a.x, b.x, c.x), square_sum(a.y, b.y, c.y),
                                                       square_sum(a.z, b.z, c.z)};
    }
    solid.centre = (1 / solid.volume) * solid.centre;
    return solid;
}

ShapeData make_hull(std::vector<Vec> points)
{
    ShapeData hull{ShapeKind::kHull, {}, std::move(points), {}};
    hull.triangles = hull_faces(hull.points);
    drop_inner_points(hull);
    const Vec centre = integrate(hull).centre;
    for (Vec& point : hull.points) point = point - centre;
    return hull;
}

std::vector<Vec> spiral_points(int n, double radius)
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec> points;
    for (int i = 0; i < n; ++i) {
        const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z),
                     angle = i * 2 * scenes::kPi / golden;
        points.push_back(radius * Vec{r * std::cos(angle), r * std::sin(angle), z});
    }
    return points;
}

std::vector<Vec> random_points(int n, double radius, scenes::Lcg& random)
{
    std::vector<Vec> points;
    while (int(points.size()) < n) {
        const Vec p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const double size = length(p);
        if (size > 0.1 && size < 1) points.push_back((radius / size) * p);
    }
    return points;
}

}  // namespace epode::bench
