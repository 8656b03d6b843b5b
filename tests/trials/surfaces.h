// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Terrain of a height function z = f(x, y), as a height field or a mesh of triangles over the same samples. The data
// live as long as the program, which is one cell.
#pragma once

#include "stage.h"

#include <functional>

namespace epode::trials {

struct Grid {
    double x, y;  // the corner with the smallest coordinates
    int nx, ny;   // cells
    double cell;  // m
};
using Height = std::function<double(double x, double y)>;

dGeomID height_field(Stage& stage, const Grid& grid, const Height& height);
// Two triangles a cell.
dGeomID grid_mesh(Stage& stage, const Grid& grid, const Height& height);
// Any triangles: corners of three numbers, indices of three.
dGeomID mesh(Stage& stage, const std::vector<Vec>& corners, const std::vector<dTriIndex>& indices);
dTriMeshDataID mesh_data(const std::vector<Vec>& corners, const std::vector<dTriIndex>& indices);
// A box of 12 triangles.
dGeomID box_mesh(Stage& stage, Vec size, Vec at);

}  // namespace epode::trials
