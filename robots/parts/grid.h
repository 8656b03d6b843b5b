// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A mesh as cells of a grid, for its decomposition: which cells the surface touches, which it encloses, and how far the
// others are away from it. Cell (i, j, k) spans origin + s (i, j, k) to origin + s (i + 1, j + 1, k + 1); one layer of free
// cells surrounds the mesh. Enclosed is what a walk from outside over faces of cells does not reach, so gaps narrower than a
// cell do no harm, and a mesh with larger ones is its surface alone.
//   surface    the separating axes of a triangle and a box (Akenine-Moeller, "Fast 3D triangle-box overlap testing", 2001)
//   distance   squared, in cells, from centre to centre: the lower envelope of parabolas, axis by axis (Felzenszwalb and
//              Huttenlocher, "Distance transforms of sampled functions", 2012), in integers
#pragma once

#include <cstdint>
#include <vector>

#include "robots/model.h"

namespace epode::robots {

enum class Cell : std::uint8_t { kFree, kSurface, kEnclosed };

class Grid {
  public:
    // A mesh of finite vertices and indices in range whose box has a side that is not 0; cells of at least a
    // kMaxSide-th of the longest, and larger ones where triangles are many and large.
    Grid(const Mesh& mesh, double cell);

    static constexpr int kMaxSide = 160;

    double cell() const { return cell_; }
    Vec origin() const { return origin_; }
    int size(int axis) const { return sizes_[size_t(axis)]; }
    Cell at(int i, int j, int k) const { return cells_[index(i, j, k)]; }
    // Of a free cell, from its centre to that of the nearest cell of the surface.
    std::uint32_t squared_distance(int i, int j, int k) const { return squares_[index(i, j, k)]; }
    Vec centre(int i, int j, int k) const { return origin_ + cell_ * Vec{i + 0.5, j + 0.5, k + 0.5}; }
    // The cell of a coordinate along an axis.
    int cell_of(int axis, double x) const;

    // From the middle of a free cell to the nearest triangle.
    double exact_distance(int i, int j, int k) const;
    // Whether the mesh's solid has the point: a cell of the surface decides by what a ray crosses, and in meshes that are not
    // closed it counts as solid.
    bool has(Vec point) const;
    bool is_closed() const { return closed_; }

  private:
    size_t index(int i, int j, int k) const
    {
        return (size_t(k) * size_t(sizes_[1]) + size_t(j)) * size_t(sizes_[0]) + size_t(i);
    }
    double cells_of_triangles() const;
    void mark_surface();
    void mark_enclosed();
    void measure_distances();
    double distance_in(size_t cell, Vec point) const;

    const Mesh& mesh_;
    double cell_;
    Vec origin_;
    std::array<int, 3> sizes_{};
    bool closed_ = false;
    std::vector<Cell> cells_;
    std::vector<std::uint32_t> squares_;
    std::vector<std::uint32_t> first_,
        listed_;  // triangles of each cell: listed_[first_[c]] ... listed_[first_[c + 1] - 1]
};

// Every edge has two triangles, wound against each other; vertices at the same place count as one.
bool is_closed(const Mesh& mesh);

}  // namespace epode::robots
