// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See grid.h.
#include "robots/parts/grid.h"

#include <algorithm>
#include <numeric>

#include "robots/parts/triangles.h"

namespace epode::robots {

namespace {

constexpr std::uint32_t kFar = 1u << 30;
constexpr double kMaxEntries = 1e8;  // of cells by triangles; beyond that cells are larger

// One line of the distance transform: values f at stride, replaced by min over q of (p - q)^2 + f(q).
class Line {
  public:
    explicit Line(int longest) : f_(size_t(longest)), places_(size_t(longest)), ends_(size_t(longest) + 1) {}
    void transform(std::uint32_t* values, int count, size_t stride)
    {
        for (int i = 0; i < count; ++i) f_[size_t(i)] = values[size_t(i) * stride];
        int last = -1;
        for (int q = 0; q < count; ++q) {
            if (f_[size_t(q)] >= kFar) continue;
            while (last >= 0 && meets(places_[size_t(last)], q) <= ends_[size_t(last)]) --last;
            ++last;
            ends_[size_t(last)] = last == 0 ? -1 : meets(places_[size_t(last) - 1], q);
            places_[size_t(last)] = q;
        }
        for (int p = 0, k = 0; p < count && last >= 0; ++p) {
            while (k < last && ends_[size_t(k) + 1] < p) ++k;
            const std::int64_t way = p - places_[size_t(k)];
            values[size_t(p) * stride] = std::uint32_t(way * way + f_[size_t(places_[size_t(k)])]);
        }
    }

  private:
    // The last place at which the parabola of q is not below that of r < q.
    std::int64_t meets(int r, int q) const
    {
        const std::int64_t numerator = std::int64_t(f_[size_t(q)]) + std::int64_t(q) * q -
                                       std::int64_t(f_[size_t(r)]) - std::int64_t(r) * r;
        const std::int64_t denominator = 2 * std::int64_t(q - r);
        return numerator >= 0 ? numerator / denominator : -((-numerator + denominator - 1) / denominator);
    }
    std::vector<std::int64_t> f_;
    std::vector<int> places_;
    std::vector<std::int64_t> ends_;
};

}  // namespace

Grid::Grid(const Mesh& mesh, double cell) : mesh_(mesh), cell_(cell), closed_(epode::robots::is_closed(mesh))
{
    Vec low = mesh.vertices[mesh.triangles[0][0]], high = low;
    for (const auto& t : mesh.triangles)
        for (std::uint32_t corner : t)
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], mesh.vertices[corner][k]);
                high[k] = std::max(high[k], mesh.vertices[corner][k]);
            }
    const Vec side = high - low;
    const double longest = std::max({side.x, side.y, side.z});
    cell_ = std::max(cell_, longest / kMaxSide);
    while (cells_of_triangles() > kMaxEntries && cell_ < longest / 2) cell_ *= 2;
    for (int k = 0; k < 3; ++k) sizes_[size_t(k)] = std::max(1, int(std::ceil(side[k] / cell_ - 1e-9))) + 2;
    origin_ = low - Vec{cell_, cell_, cell_};
    cells_.assign(size_t(sizes_[0]) * size_t(sizes_[1]) * size_t(sizes_[2]), Cell::kFree);
    mark_surface();
    mark_enclosed();
    measure_distances();
}

// About how many cells the boxes of all triangles have together.
double Grid::cells_of_triangles() const
{
    double sum = 0;
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
        const Corners c = corners_of(mesh_, t);
        double its = 1;
        for (int k = 0; k < 3; ++k)
            its *=
                2 + (std::max({c[0][k], c[1][k], c[2][k]}) - std::min({c[0][k], c[1][k], c[2][k]})) / cell_;
        sum += its;
    }
    return sum;
}

int Grid::cell_of(int axis, double x) const
{
    const double place = std::floor((x - origin_[axis]) / cell_);
    return int(std::clamp(place, 0.0, double(sizes_[size_t(axis)] - 1)));
}

// Twice over the same cells: to count the triangles of each, then to list them.
void Grid::mark_surface()
{
    const double half = cell_ / 2 * (1 + 1e-9);
    const auto each = [&](auto&& visit) {
        for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const Corners corners = corners_of(mesh_, t);
            int from[3], to[3];
            for (int k = 0; k < 3; ++k) {
                const double a = corners[0][k], b = corners[1][k], c = corners[2][k];
                from[k] = std::max(1, cell_of(k, std::min({a, b, c}) - 1e-9 * cell_));
                to[k] = std::min(sizes_[size_t(k)] - 2, cell_of(k, std::max({a, b, c}) + 1e-9 * cell_));
            }
            for (int k = from[2]; k <= to[2]; ++k)
                for (int j = from[1]; j <= to[1]; ++j)
                    for (int i = from[0]; i <= to[0]; ++i)
                        if (touches_box(corners, centre(i, j, k), half)) visit(index(i, j, k), t);
        }
    };
    first_.assign(cells_.size() + 1, 0);
    each([&](size_t cell, size_t) { ++first_[cell + 1], cells_[cell] = Cell::kSurface; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    listed_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each([&](size_t cell, size_t t) { listed_[next[cell]++] = std::uint32_t(t); });
}

void Grid::mark_enclosed()
{
    for (Cell& cell : cells_)
        if (cell == Cell::kFree) cell = Cell::kEnclosed;
    std::vector<size_t> open{0};
    cells_[0] = Cell::kFree;
    const size_t row = size_t(sizes_[0]), layer = row * size_t(sizes_[1]);
    const auto reach = [&](size_t cell) {
        if (cells_[cell] == Cell::kEnclosed) cells_[cell] = Cell::kFree, open.push_back(cell);
    };
    while (!open.empty()) {
        const size_t c = open.back();
        open.pop_back();
        const size_t i = c % row, j = c / row % size_t(sizes_[1]), k = c / layer;
        if (i > 0) reach(c - 1);
        if (i + 1 < row) reach(c + 1);
        if (j > 0) reach(c - row);
        if (j + 1 < size_t(sizes_[1])) reach(c + row);
        if (k > 0) reach(c - layer);
        if (k + 1 < size_t(sizes_[2])) reach(c + layer);
    }
}

void Grid::measure_distances()
{
    squares_.resize(cells_.size());
    for (size_t i = 0; i < cells_.size(); ++i) squares_[i] = cells_[i] == Cell::kFree ? kFar : 0;
    const size_t row = size_t(sizes_[0]), layer = row * size_t(sizes_[1]);
    Line line(std::max({sizes_[0], sizes_[1], sizes_[2]}));
    for (size_t k = 0; k < size_t(sizes_[2]); ++k)
        for (size_t j = 0; j < size_t(sizes_[1]); ++j)
            line.transform(&squares_[k * layer + j * row], sizes_[0], 1);
    for (size_t k = 0; k < size_t(sizes_[2]); ++k)
        for (size_t i = 0; i < row; ++i) line.transform(&squares_[k * layer + i], sizes_[1], row);
    for (size_t j = 0; j < size_t(sizes_[1]); ++j)
        for (size_t i = 0; i < row; ++i) line.transform(&squares_[j * row + i], sizes_[2], layer);
}

double Grid::distance_in(size_t cell, Vec point) const
{
    double best = HUGE_VAL;
    for (std::uint32_t n = first_[cell]; n < first_[cell + 1]; ++n)
        best = std::min(best, squared_distance_to(corners_of(mesh_, listed_[n]), point));
    return best;
}

// Shell by shell of cells around the point; what lies in the shell r is at least (r - 1/2) cells away.
double Grid::exact_distance(int i, int j, int k) const
{
    const Vec point = centre(i, j, k);
    const int begin = int(std::sqrt(double(squared_distance(i, j, k)) / 3));
    double best = HUGE_VAL;
    const int longest = std::max({sizes_[0], sizes_[1], sizes_[2]});
    for (int r = begin; r <= longest; ++r) {
        const double away = (r - 0.5) * cell_;
        if (r > begin && away > 0 && best <= away * away) break;
        for (int z = std::max(0, k - r); z <= std::min(sizes_[2] - 1, k + r); ++z)
            for (int y = std::max(0, j - r); y <= std::min(sizes_[1] - 1, j + r); ++y) {
                const bool is_face = z == k - r || z == k + r || y == j - r || y == j + r;
                const int step = is_face || r == 0 ? 1 : 2 * r;
                for (int x = i - r; x <= i + r; x += step)
                    if (x >= 0 && x < sizes_[0]) best = std::min(best, distance_in(index(x, y, z), point));
            }
    }
    return std::sqrt(best);
}

bool Grid::has(Vec point) const
{
    const Cell its = at(cell_of(0, point.x), cell_of(1, point.y), cell_of(2, point.z));
    if (its != Cell::kSurface) return its == Cell::kEnclosed;
    if (!closed_) return true;
    int winding = 0;
    for (size_t t = 0; t < mesh_.triangles.size(); ++t)
        winding += crossing_above(corners_of(mesh_, t), point);
    return winding != 0;
}

bool is_closed(const Mesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.vertices.size()), place(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const Vec v = mesh.vertices[i];
        return std::array<double, 3>{v.x, v.y, v.z};
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (size_t i = 0; i < order.size(); ++i)
        place[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? place[order[i - 1]] : order[i];
    std::vector<std::array<std::uint32_t, 3>>
        edges;  // ends, the lower first, and whether they were turned round
    for (const auto& t : mesh.triangles) {
        const std::uint32_t c[3] = {place[t[0]], place[t[1]], place[t[2]]};
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
        for (size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = c[k], b = c[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), std::uint32_t(a > b)});
        }
    }
    std::sort(edges.begin(), edges.end());
    for (size_t i = 0; i < edges.size();) {
        int balance = 0;
        size_t end = i;
        for (; end < edges.size() && edges[end][0] == edges[i][0] && edges[end][1] == edges[i][1]; ++end)
            balance += edges[end][2] ? -1 : 1;
        if (balance != 0) return false;
        i = end;
    }
    return !edges.empty();
}

}  // namespace epode::robots
