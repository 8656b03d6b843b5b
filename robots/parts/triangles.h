// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles alone: against boxes, points and upward rays.
#pragma once

#include "robots/model.h"

namespace epode::robots {

using Corners = std::array<Vec, 3>;

inline Corners corners_of(const Mesh& mesh, size_t triangle)
{
    const auto& t = mesh.triangles[triangle];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// A cube of that half side.
bool touches_box(const Corners& corners, Vec centre, double half);
double squared_distance_to(const Corners& corners, Vec point);
// How a ray from the point along z goes through the triangle: 1 out of what lies behind it, -1 into it, 0 past it. Of a
// ray through an edge or corner one of the triangles there is crossed.
int crossing_above(const Corners& corners, Vec point);

}  // namespace epode::robots
