// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A square landscape of triangles over a regular grid, and its height at any point: of the same two triangles
// a cell, cut from its low corner to its high one, that the engines get as a mesh.
#pragma once

#include <vector>

#include "scenes/vectors.h"

namespace epode::bench {

struct Terrain {
    int cells = 0;               // to a side
    double pitch = 1;            // m
    std::vector<double> height;  // (cells + 1)^2, x quickest; the middle vertex is over the origin

    double vertex(int i, int j) const { return height[size_t(j) * size_t(cells + 1) + size_t(i)]; }
    double coordinate(int i) const { return pitch * (i - 0.5 * cells); }
    // Upward normal too, if wanted. Outside the border counts what is nearest.
    double at(double x, double y, scenes::Vec* normal = nullptr) const;
};

// Hills of a few waves that do not repeat, and a little noise.
Terrain make_hills(int cells, double pitch);

}  // namespace epode::bench
