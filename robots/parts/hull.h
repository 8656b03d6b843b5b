// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex hulls of points by dCreateConvexHull, as arrays that dCreateConvex takes.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "robots/geometry.h"

namespace epode::robots {

struct Hull {
    std::vector<dReal> planes, points;
    std::vector<unsigned> polygons;
    double volume = 0;

    bool is_empty() const { return polygons.empty(); }
    std::vector<Vec> corners() const;
    // How far a point is outside, negative inside: the largest of the planes' heights.
    double height(Vec point) const;
};

// Plates, lines and fewer than four points have no hull: it stays empty. max_vertices: 0 or at least 4.
Hull hull_of(const std::vector<Vec>& points, unsigned max_vertices);

}  // namespace epode::robots
