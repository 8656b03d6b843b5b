// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which four points of a manifold to keep. The usual reasoning about support polygons: the deepest point
// carries the load, the farthest from it gives the longest lever, the next two span the largest area on
// either side of that line. Sorting by depth alone was rejected: it keeps four neighbours and the body tips.
// A later point must beat an earlier one by a small margin, so that rounding in a symmetric manifold does not
// swap the chosen points from one step to the next. The points lie coordinate by coordinate, so that four are
// judged at a time, and in any frame: only their differences count.
#pragma once

#include "math/vec.h"

namespace epode {

struct ManifoldPoints {
    static constexpr int kMax = 64;
    alignas(16) Real x[kMax];
    alignas(16) Real y[kMax];
    alignas(16) Real z[kMax];
    alignas(16) Real depth[kMax];
    int count = 0;
    void add(Vec3 p, Real d)
    {
        x[count] = p.x, y[count] = p.y, z[count] = p.z, depth[count] = d;
        ++count;
    }
};

inline constexpr int kBestFour = 4;
inline constexpr Real kManifoldCosine = Real(0.996);  // of normals within 5 degrees, which make one manifold

// Indices of the at most `wanted` (1 to 4) best of the points, of which there are some; the number of them.
// Points apart, of negative depth, only where fewer than that touch.
// `normal` is the manifold's, unit, in the frame of the points. Free places are written to.
int best_four(ManifoldPoints& points, Vec3 normal, int wanted, int* chosen);

}  // namespace epode
