// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "surfaces.h"

namespace epode::trials {

namespace {

struct Triangles {
    std::vector<double> corners;
    std::vector<dTriIndex> indices;
};

std::deque<Triangles>& kept_triangles()
{
    static std::deque<Triangles> kept;
    return kept;
}

}  // namespace

// A height field's own y is up: it is turned about x, and its depth runs against the world's y.
dGeomID height_field(Stage& stage, const Grid& grid, const Height& height)
{
    const int wide = grid.nx + 1, deep = grid.ny + 1;
    std::vector<double> heights(size_t(wide) * size_t(deep));
    double low = 0, high = 0;
    for (int j = 0; j < deep; ++j) {
        for (int i = 0; i < wide; ++i) {
            const double z = height(grid.x + i * grid.cell, grid.y + (grid.ny - j) * grid.cell);
            heights[size_t(j) * size_t(wide) + size_t(i)] = z;
            low = std::min(low, z), high = std::max(high, z);
        }
    }
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(data, heights.data(), 1, grid.nx * grid.cell, grid.ny * grid.cell, wide,
                                    deep, 1, 0, 1, 0);
    dGeomHeightfieldDataSetBounds(data, low, high);
    const Vec centre{grid.x + grid.nx * grid.cell / 2, grid.y + grid.ny * grid.cell / 2, 0};
    return stage.place(dCreateHeightfield(stage.space, data, 1), centre, turn(kX, kPi / 2));
}

dTriMeshDataID mesh_data(const std::vector<Vec>& corners, const std::vector<dTriIndex>& indices)
{
    Triangles& kept = kept_triangles().emplace_back();
    for (const Vec& corner : corners) kept.corners.insert(kept.corners.end(), {corner.x, corner.y, corner.z});
    kept.indices = indices;
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, kept.corners.data(), 3 * sizeof(double), int(corners.size()),
                                kept.indices.data(), int(indices.size()), 3 * sizeof(dTriIndex));
    return data;
}

dGeomID mesh(Stage& stage, const std::vector<Vec>& corners, const std::vector<dTriIndex>& indices)
{
    return stage.place(dCreateTriMesh(stage.space, mesh_data(corners, indices), nullptr, nullptr, nullptr));
}

dGeomID grid_mesh(Stage& stage, const Grid& grid, const Height& height)
{
    std::vector<Vec> corners;
    std::vector<dTriIndex> indices;
    const auto at = [&](int i, int j) { return dTriIndex(i * (grid.ny + 1) + j); };
    for (int i = 0; i <= grid.nx; ++i) {
        for (int j = 0; j <= grid.ny; ++j) {
            const double x = grid.x + i * grid.cell, y = grid.y + j * grid.cell;
            corners.push_back({x, y, height(x, y)});
            if (i == grid.nx || j == grid.ny) continue;
            const dTriIndex a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
            indices.insert(indices.end(), {a, b, c, c, b, d});
        }
    }
    return mesh(stage, corners, indices);
}

dGeomID box_mesh(Stage& stage, Vec size, Vec at)
{
    std::vector<Vec> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(
            {(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z});
    const std::vector<dTriIndex> indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    const dGeomID geom = mesh(stage, corners, indices);
    dGeomSetPosition(geom, at.x, at.y, at.z);
    return geom;
}

}  // namespace epode::trials
