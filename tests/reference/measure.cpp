// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Overlap and distance by plain means: see measure.h.
#include "measure.h"

#include <algorithm>
#include <cmath>

namespace epode::reference {

namespace {

constexpr double kPi = 3.14159265358979323846;

// Evenly spread: a spiral by the golden angle.
Point spiral(int i, int count)
{
    const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z),
                 angle = kPi * (3 - std::sqrt(5.0)) * i;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

const std::vector<Point>& sphere_of(int count)
{
    static std::vector<Point> points;
    if (int(points.size()) != count) {
        points.clear();
        for (int i = 0; i < count; ++i) points.push_back(spiral(i, count));
    }
    return points;
}

void better(const Solid& a, const Solid& b, Overlap& found)
{
    int moves = 0;
    for (double step = 0.02; step > 1e-10 && moves < 400; ++moves) {
        const Point n = found.normal, axis = std::fabs(n[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
        const Point u = unit(sum(axis, -dot(axis, n), n));
        const Point v = {n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
        bool moved = false;
        for (int k = 0; k < 12; ++k) {
            const double angle = kPi * k / 6;
            const Point m = unit(sum(sum(n, step * std::cos(angle), u), step * std::sin(angle), v));
            const double h = overlap_along(a, b, m);
            if (h < found.depth) found = {h, m}, moved = true;
        }
        if (!moved) step *= 0.5;
    }
}

// The point of the affine hull of up to four points nearest to the origin, by its weights; false when they
// are not all positive. The normal equations of the edges from the first point, by elimination.
bool nearest_of(const Point* const* p, int count, Point& out)
{
    double m[3][4] = {};
    const int n = count - 1;
    Point edge[3];
    for (int i = 0; i < n; ++i) edge[i] = sum(*p[i + 1], -1, *p[0]);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) m[i][j] = dot(edge[i], edge[j]);
        m[i][3] = -dot(edge[i], *p[0]);
    }
    for (int i = 0; i < n; ++i) {
        int best = i;
        for (int j = i + 1; j < n; ++j)
            if (std::fabs(m[j][i]) > std::fabs(m[best][i])) best = j;
        std::swap(m[i], m[best]);
        if (!(std::fabs(m[i][i]) > 1e-14)) return false;
        for (int j = 0; j < n; ++j) {
            if (j == i) continue;
            const double k = m[j][i] / m[i][i];
            for (int c = i; c < 4; ++c) m[j][c] -= k * m[i][c];
        }
    }
    double first = 1;
    out = *p[0];
    for (int i = 0; i < n; ++i) {
        const double w = m[i][3] / m[i][i];
        if (!(w >= 0)) return false;
        first -= w, out = sum(out, w, edge[i]);
    }
    return first >= 0;
}

// Keeps of the points those that carry the nearest one.
Point reduce(std::vector<Point>& points)
{
    Point best{};
    double least = 1e300;
    std::vector<Point> kept;
    for (unsigned subset = 1; subset < 1u << points.size(); ++subset) {
        const Point* chosen[5];
        int count = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (subset >> i & 1) chosen[count++] = &points[i];
        Point p;
        if (count > 4 || !nearest_of(chosen, count, p) || !(dot(p, p) < least)) continue;
        least = dot(p, p), best = p;
        kept.clear();
        for (int i = 0; i < count; ++i) kept.push_back(*chosen[i]);
    }
    points = kept;
    return best;
}

}  // namespace

double overlap_along(const Solid& a, const Solid& b, const Point& normal)
{
    const double low = dot(normal, a.support({-normal[0], -normal[1], -normal[2]}));
    return (b.is_plane() ? b.distance() : dot(normal, b.support(normal))) - low;
}

Overlap least_overlap(const Solid& a, const Solid& b, int directions)
{
    if (b.is_plane()) return {overlap_along(a, b, b.normal()), b.normal()};
    constexpr std::size_t kBest = 4;
    std::vector<Overlap> best;
    for (const Point& n : sphere_of(directions)) {
        const double h = overlap_along(a, b, n);
        if (best.size() == kBest && !(h < best.back().depth)) continue;
        if (best.size() == kBest) best.pop_back();
        best.push_back({h, n});
        std::sort(best.begin(), best.end(),
                  [](const Overlap& x, const Overlap& y) { return x.depth < y.depth; });
    }
    for (Overlap& one : best) better(a, b, one);
    return *std::min_element(best.begin(), best.end(),
                             [](const Overlap& x, const Overlap& y) { return x.depth < y.depth; });
}

double distance(const Solid& a, const Solid& b, Point& way)
{
    if (b.is_plane()) {
        way = b.normal();
        return std::fmax(0, -overlap_along(a, b, way));
    }
    const auto support = [&](const Point& d) {
        return sum(a.support(d), -1, b.support({-d[0], -d[1], -d[2]}));
    };
    std::vector<Point> points = {support({1, 0, 0})};
    Point nearest = points[0];
    for (int i = 0; i < 500; ++i) {
        const double n2 = dot(nearest, nearest);
        if (n2 < 1e-24) return 0;
        const Point next = support({-nearest[0], -nearest[1], -nearest[2]});
        if (n2 - dot(nearest, next) <= 1e-14 * n2) break;
        points.push_back(next);
        const Point closer = reduce(points);
        if (points.size() == 4 || !(dot(closer, closer) < n2)) {
            if (points.size() == 4) return 0;
            break;
        }
        nearest = closer;
    }
    way = unit(nearest);
    return norm(nearest);
}

}  // namespace epode::reference
