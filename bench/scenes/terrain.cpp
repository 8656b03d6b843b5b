// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See terrain.h.
#include "bench/scenes/terrain.h"

#include <algorithm>
#include <cmath>

namespace epode::bench {

double Terrain::at(double x, double y, scenes::Vec* normal) const
{
    const double u = std::clamp(x / pitch + 0.5 * cells, 0.0, double(cells));
    const double v = std::clamp(y / pitch + 0.5 * cells, 0.0, double(cells));
    const int i = std::min(int(u), cells - 1), j = std::min(int(v), cells - 1);
    const double a = u - i, b = v - j;
    const double low = vertex(i, j), high = vertex(i + 1, j + 1);
    // Slopes per cell of the triangle below (a > b) or above the cut.
    const double middle = a > b ? vertex(i + 1, j) : vertex(i, j + 1);
    const double du = a > b ? middle - low : high - middle, dv = a > b ? high - middle : middle - low;
    if (normal) {
        const scenes::Vec up{-du / pitch, -dv / pitch, 1};
        *normal = (1 / length(up)) * up;
    }
    return low + a * du + b * dv;
}

Terrain make_hills(int cells, double pitch)
{
    Terrain terrain{cells, pitch, {}};
    scenes::Lcg random(7);
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const double x = terrain.coordinate(i), y = terrain.coordinate(j);
            terrain.height.push_back(2 * std::sin(0.10 * x) * std::sin(0.13 * y) +
                                     0.5 * std::sin(0.41 * x + 0.7 * y) + random.uniform(-0.1, 0.1));
        }
    }
    return terrain;
}

}  // namespace epode::bench
