// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See cut.h. A cut is then moved to a face of the mesh across the axis, where one is less than a cell away: so the parts of a
// bracket are its plates.
#include "robots/parts/cut.h"

#include <algorithm>

#include "robots/parts/hull.h"
#include "robots/parts/triangles.h"

namespace epode::robots {

namespace {

constexpr int kCoarse = 12;  // cuts tried on an axis at first, then as many again around the best
// What a cut at the end costs more than one in the middle, and one across no length more than one across the longest, as
// shares of the volume: where no cut alone helps, as in a ring, halves of the longest side are what further cuts help most.
constexpr double kMiddle = 0.01, kLong = 0.05;

std::vector<Vec> make_directions()
{
    std::vector<Vec> out;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z) {
                const int ones = (x * x == 1) + (y * y == 1) + (z * z == 1),
                          twos = (x * x == 4) + (y * y == 4) + (z * z == 4);
                if ((twos == 0 && ones > 0) || (twos == 1 && ones == 1))
                    out.push_back({double(x), double(y), double(z)});
            }
    return out;
}

const std::vector<Vec>& directions()
{
    static const std::vector<Vec> all = make_directions();
    return all;
}

// Of a set of cells, the extreme corner in each direction.
struct Extremes {
    std::vector<double> values = std::vector<double>(directions().size(), -HUGE_VAL);
    std::vector<Vec> corners = std::vector<Vec>(directions().size());

    void add(Vec centre, double half)
    {
        for (size_t n = 0; n < values.size(); ++n) {
            const Vec d = directions()[n];
            const double value = dot(d, centre);
            if (value <= values[n]) continue;
            values[n] = value;
            for (int k = 0; k < 3; ++k) corners[n][k] = centre[k] + half * (d[k] > 0 ? 1 : -1);
        }
    }
    void add(const Extremes& other)
    {
        for (size_t n = 0; n < values.size(); ++n)
            if (other.values[n] > values[n]) values[n] = other.values[n], corners[n] = other.corners[n];
    }
    double volume() const
    {
        std::vector<Vec> points;
        for (size_t n = 0; n < values.size(); ++n)
            if (values[n] > -HUGE_VAL) points.push_back(corners[n]);
        return hull_of(points, 0).volume;
    }
};

// All cuts of a part across one axis; cut c lies before the cell c.
class AxisCuts {
  public:
    AxisCuts(const Grid& grid, int axis, const int (&low)[3], const int (&high)[3])
        : grid_(grid), axis_(axis), first_(low[axis]), count_(high[axis] - low[axis] + 1)
    {
        before_.resize(size_t(count_));
        for (int c = 0; c < count_; ++c) add_slab(c, low, high);
        after_ = before_;
        for (int c = 1; c < count_; ++c) before_[size_t(c)].add(before_[size_t(c) - 1]);
        for (int c = count_ - 1; c-- > 0;) after_[size_t(c)].add(after_[size_t(c) + 1]);
    }
    int count() const { return count_; }
    double place(int c) const { return grid_.origin()[axis_] + grid_.cell() * (first_ + c); }
    double cost(int c, double whole, int longest) const
    {
        const double off = std::fabs(double(c) / count_ - 0.5), shorter = 1 - double(count_) / longest;
        return before_[size_t(c) - 1].volume() + after_[size_t(c)].volume() +
               (kMiddle * off + kLong * shorter) * whole;
    }

  private:
    // The ends of each row of solid cells: between them nothing is extreme.
    void add_slab(int c, const int (&low)[3], const int (&high)[3])
    {
        const int along = (axis_ + 1) % 3, across = (axis_ + 2) % 3;
        int cell[3];
        cell[axis_] = first_ + c;
        const auto is_solid = [&] { return grid_.at(cell[0], cell[1], cell[2]) != Cell::kFree; };
        const auto add = [&] {
            before_[size_t(c)].add(grid_.centre(cell[0], cell[1], cell[2]), grid_.cell() / 2);
        };
        for (cell[across] = low[across]; cell[across] <= high[across]; ++cell[across]) {
            int& place = cell[along];
            place = low[along];
            while (place <= high[along] && !is_solid()) ++place;
            if (place > high[along]) continue;
            add();
            const int begin = place;
            for (place = high[along]; place > begin && !is_solid();) --place;
            if (place > begin) add();
        }
    }

    const Grid& grid_;
    int axis_, first_, count_;
    std::vector<Extremes> before_, after_;
};

// The face across the axis within a cell of the place, of the largest area there; else the place.
double snapped(const Mesh& mesh, const Grid& grid, const BoxPart& part, int axis, double place)
{
    struct Face {
        double place, area;
    };
    std::vector<Face> faces;
    const double flat = 1e-6 * grid.cell();
    for (std::uint32_t t : part.triangles) {
        const Corners c = corners_of(mesh, t);
        const double at = c[0][axis];
        const bool is_across = std::fabs(c[1][axis] - at) <= flat && std::fabs(c[2][axis] - at) <= flat;
        if (is_across && std::fabs(at - place) <= grid.cell())
            faces.push_back({at, length(cross(c[1] - c[0], c[2] - c[0])) / 2});
    }
    std::stable_sort(faces.begin(), faces.end(), [](Face a, Face b) { return a.place < b.place; });
    double best = place, largest = grid.cell() * grid.cell();
    for (size_t i = 0; i < faces.size();) {
        double area = 0;
        const double at = faces[i].place;
        for (; i < faces.size() && faces[i].place - at <= 2 * flat; ++i) area += faces[i].area;
        if (area > largest) largest = area, best = at;
    }
    return best;
}

}  // namespace

Cut best_cut(const Mesh& mesh, const Grid& grid, const BoxPart& part, Vec low, Vec high)
{
    const double inner = 1e-6 * grid.cell();
    int from[3], to[3];
    double whole = 1;
    for (int k = 0; k < 3; ++k) {
        from[k] = grid.cell_of(k, low[k] + inner), to[k] = grid.cell_of(k, high[k] - inner);
        whole *= high[k] - low[k];
    }
    const int longest = 1 + std::max({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
    Cut best;
    double least = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
        if (to[axis] <= from[axis]) continue;
        const AxisCuts cuts(grid, axis, from, to);
        int best_of_axis = 0;
        double least_of_axis = HUGE_VAL;
        const auto attempt = [&](int c) {
            const double cost = c > 0 && c < cuts.count() ? cuts.cost(c, whole, longest) : HUGE_VAL;
            if (cost < least_of_axis) least_of_axis = cost, best_of_axis = c;
        };
        const int stride = std::max(1, cuts.count() / kCoarse);
        for (int c = stride; c < cuts.count(); c += stride) attempt(c);
        for (int middle = best_of_axis, c = middle - stride + 1; c < middle + stride; ++c)
            if (c != middle) attempt(c);
        if (least_of_axis < least) least = least_of_axis, best = {axis, cuts.place(best_of_axis)};
    }
    if (best.axis < 0) return best;
    const double moved = snapped(mesh, grid, part, best.axis, best.place);
    const bool is_inside = moved > low[best.axis] + inner && moved < high[best.axis] - inner;
    if (is_inside) best.place = moved;
    return best;
}

}  // namespace epode::robots
