// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See box_part.h. Polygons are clipped by one side after the other (Sutherland and Hodgman, 1974).
#include "robots/parts/box_part.h"

#include <algorithm>

namespace epode::robots {

namespace {

using Polygon = std::vector<Vec>;

// Keeps what has sign * x[axis] <= sign * limit.
void clip(Polygon& polygon, int axis, double limit, double sign)
{
    if (std::isinf(limit)) return;
    const auto over = [&](Vec v) { return sign * (v[axis] - limit); };
    if (std::all_of(polygon.begin(), polygon.end(), [&](Vec v) { return over(v) <= 0; })) return;
    Polygon out;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double at_a = over(a), at_b = over(b);
        if (at_a <= 0) out.push_back(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
            Vec crossing = a + (at_a / (at_a - at_b)) * (b - a);
            crossing[axis] = limit;
            out.push_back(crossing);
        }
    }
    polygon = std::move(out);
}

void clip(Polygon& polygon, const CutBox& box)
{
    for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
        clip(polygon, axis, box.high[axis], 1);
        clip(polygon, axis, box.low[axis], -1);
    }
}

// A face in a side of the box, or one that only touches it from outside, bounds no part inside.
bool reaches_in(const Polygon& polygon, const CutBox& box, double thin)
{
    for (int axis = 0; axis < 3; ++axis) {
        const auto is_in = [&](Vec v) {
            return v[axis] > box.low[axis] + thin && v[axis] < box.high[axis] - thin;
        };
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (Vec v : polygon) low = std::min(low, v[axis]), high = std::max(high, v[axis]);
        const bool spans = low <= box.low[axis] + thin && high >= box.high[axis] - thin;
        if (!spans && std::none_of(polygon.begin(), polygon.end(), is_in)) return false;
    }
    return !polygon.empty();
}

Polygon polygon_in(const Mesh& mesh, std::uint32_t triangle, const CutBox& box)
{
    const auto& t = mesh.triangles[triangle];
    Polygon out{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    clip(out, box);
    return out;
}

// Corners of three cuts that are inside the solid, judged just inside the box.
void add_corners(const Grid& grid, const CutBox& box, double thin, std::vector<Vec>& out)
{
    for (int n = 0; n < 8; ++n) {
        Vec corner, inner;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_high = (n >> axis & 1) != 0;
            corner[axis] = is_high ? box.high[axis] : box.low[axis];
            inner[axis] = corner[axis] + (is_high ? -thin : thin);
        }
        if (is_finite(corner) && grid.has(inner)) out.push_back(corner);
    }
}

bool is_within(Vec v, const CutBox& box)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!(v[axis] >= box.low[axis] && v[axis] <= box.high[axis])) return false;
    return true;
}

}  // namespace

BoxPart cut_out(const Mesh& mesh, const BoxPart& from, const CutBox& box, double thin)
{
    BoxPart out;
    out.box = box;
    for (std::uint32_t t : from.triangles)
        if (reaches_in(polygon_in(mesh, t, box), box, thin)) out.triangles.push_back(t);
    return out;
}

// A vertex once, however many triangles meet there; corners of clipped triangles as they come.
std::vector<Vec> points_of(const Mesh& mesh, const Grid& grid, const BoxPart& part, double thin)
{
    std::vector<Vec> out;
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t t : part.triangles) {
        const auto& corners = mesh.triangles[t];
        const bool is_whole = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return is_within(mesh.vertices[corner], part.box);
        });
        if (is_whole) {
            vertices.insert(vertices.end(), corners.begin(), corners.end());
        } else {
            const Polygon polygon = polygon_in(mesh, t, part.box);
            out.insert(out.end(), polygon.begin(), polygon.end());
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (std::uint32_t vertex : vertices) out.push_back(mesh.vertices[vertex]);
    add_corners(grid, part.box, thin, out);
    return out;
}

}  // namespace epode::robots
