// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Cutting a quadrangle by a rectangle, |x| <= half_x and |y| <= half_y, side by side (Sutherland and Hodgman 1974);
// z goes along. The same rule as geometry/clip.h, in place and coordinate by coordinate: of a convex polygon one run
// of corners is outside, so two points are made and the rest moves up or down. What rounding makes of polygons
// without area may have more runs; that is cut corner by corner.
#pragma once

#include "math/vec.h"

namespace epode {

struct CutPolygon {
    static constexpr int kMax = 16;
    static constexpr int kRoom = kMax + 8;  // corners are moved eight at a time
    union {
        alignas(16) Real at[3][kRoom];  // x, y, z; in a union: left unwritten until set
    };
    int count = 4;
    CutPolygon() {}
};

// Corners outside by no more than `slack` stay as they are: flush faces would otherwise sprout pairs of nearly
// equal points.
void cut_by_rectangle(CutPolygon& polygon, Real half_x, Real half_y, Real slack);

}  // namespace epode
