// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See concavity.h. Row by row along x: the planes of the hull cut an interval out of each row of cells.
#include "robots/parts/concavity.h"

#include <algorithm>

namespace epode::robots {

namespace {

constexpr double kDiagonal = 1.7320508075688772;
constexpr size_t kMaxExact = 64;  // cells of which the exact distance is computed

struct Place {
    std::uint32_t square;
    int i, j, k;
};

struct Interval {
    double low, high;
};

// Where a line along x through (y, z) is inside the hull.
Interval inside(const Hull& hull, double y, double z)
{
    Interval out{-HUGE_VAL, HUGE_VAL};
    for (size_t n = 0; n + 4 <= hull.planes.size(); n += 4) {
        const double slope = double(hull.planes[n]);
        const double rest =
            double(hull.planes[n + 3]) - double(hull.planes[n + 1]) * y - double(hull.planes[n + 2]) * z;
        if (slope > 0)
            out.high = std::min(out.high, rest / slope);
        else if (slope < 0)
            out.low = std::max(out.low, rest / slope);
        else if (rest < 0)
            return {1, 0};
    }
    return out;
}

struct Span {
    int low[3], high[3];
};

Span span_of(const Hull& hull, const Grid& grid)
{
    Span out{};
    for (int axis = 0; axis < 3; ++axis) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t n = size_t(axis); n < hull.points.size(); n += 3)
            low = std::min(low, double(hull.points[n])), high = std::max(high, double(hull.points[n]));
        out.low[axis] = grid.cell_of(axis, low), out.high[axis] = grid.cell_of(axis, high);
    }
    return out;
}

template <class Visit>
void each_free_cell(const Hull& hull, const Grid& grid, Visit&& visit)
{
    const Span span = span_of(hull, grid);
    for (int k = span.low[2]; k <= span.high[2]; ++k)
        for (int j = span.low[1]; j <= span.high[1]; ++j) {
            const Vec first = grid.centre(0, j, k);
            const Interval row = inside(hull, first.y, first.z);
            const double from = std::ceil((row.low - first.x) / grid.cell()),
                         to = std::floor((row.high - first.x) / grid.cell());
            if (!(from <= to)) continue;
            const int begin = int(std::max(from, double(span.low[0]))),
                      end = int(std::min(to, double(span.high[0])));
            for (int i = begin; i <= end; ++i)
                if (grid.at(i, j, k) == Cell::kFree) visit(Place{grid.squared_distance(i, j, k), i, j, k});
        }
}

}  // namespace

double concavity_of(const Hull& hull, const Grid& grid, double enough)
{
    std::uint32_t largest = 0;
    each_free_cell(hull, grid, [&](Place place) { largest = std::max(largest, place.square); });
    const double reach = std::sqrt(double(largest));
    if (largest == 0 || (reach - kDiagonal / 2) * grid.cell() > enough) return reach * grid.cell();
    const double least = std::max(0.0, reach - kDiagonal);
    std::vector<Place> places;
    each_free_cell(hull, grid, [&](Place place) {
        if (double(place.square) >= least * least) places.push_back(place);
    });
    std::stable_sort(places.begin(), places.end(), [](Place a, Place b) { return a.square > b.square; });
    if (places.size() > kMaxExact) places.resize(kMaxExact);
    double out = 0;
    for (Place place : places) {
        if (out > 0 && (std::sqrt(double(place.square)) + kDiagonal / 2) * grid.cell() < out) break;
        out = std::max(out, grid.exact_distance(place.i, place.j, place.k));
    }
    return out;
}

}  // namespace epode::robots
