// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See triangles.h. Separating axes of a triangle and a cube: the cube's three, the triangle's normal, and the nine
// products of edges. The nearest point of a triangle: in the region of a corner, an edge or the face that the
// barycentric coordinates of the projection say (Ericson, "Real-Time Collision Detection", 2005, chapter 5).
#include "robots/parts/triangles.h"

#include <algorithm>

namespace epode::robots {

namespace {

bool is_separated(const Corners& corners, Vec axis, double half)
{
    const double a = dot(axis, corners[0]), b = dot(axis, corners[1]), c = dot(axis, corners[2]);
    const double reach = half * (std::fabs(axis.x) + std::fabs(axis.y) + std::fabs(axis.z));
    return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

double squared(Vec v) { return dot(v, v); }

double to_segment(Vec a, Vec b, Vec p)
{
    const Vec ab = b - a;
    const double size = squared(ab);
    const double t = size > 0 ? std::clamp(dot(p - a, ab) / size, 0.0, 1.0) : 0;
    return squared(p - a - t * ab);
}

// Which side of a -> b the point is on, seen along z. The same number with the other sign for b -> a, so that an edge of two
// triangles parts them without a gap.
double side(Vec a, Vec b, Vec p)
{
    const bool turned = a.x != b.x ? a.x > b.x : a.y > b.y;
    if (turned) std::swap(a, b);
    const double value = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    return turned ? -value : value;
}

// 0 counts as left of an edge in one direction and as right of it in the other.
bool is_left(Vec a, Vec b, Vec p)
{
    const double value = side(a, b, p);
    return value > 0 || (value == 0 && (a.x != b.x ? a.x < b.x : a.y < b.y));
}

}  // namespace

bool touches_box(const Corners& corners, Vec centre, double half)
{
    const Corners c{corners[0] - centre, corners[1] - centre, corners[2] - centre};
    const Vec units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (Vec unit : units)
        if (is_separated(c, unit, half)) return false;
    const Vec edges[3] = {c[1] - c[0], c[2] - c[1], c[0] - c[2]};
    if (is_separated(c, cross(edges[0], edges[1]), half)) return false;
    for (Vec edge : edges)
        for (Vec unit : units)
            if (is_separated(c, cross(edge, unit), half)) return false;
    return true;
}

double squared_distance_to(const Corners& corners, Vec p)
{
    const Vec a = corners[0], b = corners[1], c = corners[2], n = cross(b - a, c - a);
    const double size = squared(n);
    const bool is_over = size > 0 && dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                         dot(cross(a - c, p - c), n) >= 0;
    if (is_over) {
        const double height = dot(p - a, n);
        return height * height / size;
    }
    return std::min({to_segment(a, b, p), to_segment(b, c, p), to_segment(c, a, p)});
}

int crossing_above(const Corners& corners, Vec p)
{
    const Vec a = corners[0], b = corners[1], c = corners[2];
    const bool ab = is_left(a, b, p), bc = is_left(b, c, p), ca = is_left(c, a, p);
    if (ab != bc || bc != ca) return 0;
    const Vec n = cross(b - a, c - a);
    if (n.z == 0) return 0;
    const double height = (dot(n, a) - n.x * p.x - n.y * p.y) / n.z;
    return height <= p.z ? 0 : n.z > 0 ? 1 : -1;
}

}  // namespace epode::robots
