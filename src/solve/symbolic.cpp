// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 1. Lengths of the columns, from the elimination tree.
// 2. Fronts. From the leaves up, the front that ends in column j is joined to that of its parent when an
//    estimate of time says so: longer inner products against arithmetic on blocks that are zero. The rows of
//    a front are those of its last column.
// 3. Columns are numbered anew, front by front, each front in the place of its last column: children stay
//    before parents, so the fill does not change, and branches of the tree alternate as the order of
//    elimination had them; the processor then overlaps their arithmetic, which within a branch is a chain of
//    dependent operations.
// 4. The rows of the fronts, in ascending order, and where their products go.
#include "solve/symbolic.h"

#include <algorithm>
#include <cstdint>

#include "solve/elimination_tree.h"

namespace epode {
namespace {

// Time of a front, in units of one 6x6 times 6x6: its products, and half a unit for each block that it has or
// subtracts something from. Measured on walls, piles and ladders; three times as much or none at all for the
// blocks costs a few per cent.
double estimate(double width, double below)
{
    constexpr double kTouch = 0.5;
    const double outer = below * (below + 1) / 2;
    const double products = width * (outer + (width + 1) * (below / 2 + (width + 2) / 6));
    return products + kTouch * (outer + width * (width + below));
}

class Planner {
  public:
    Planner(const BodyGraph& graph, std::span<const int> order, Arena& arena, FactorPlan& out)
        : graph_(graph), order_(order), arena_(arena), plan_(out), n_(graph.size())
    {}

    bool make()
    {
        below_ = arena_.take_zeroed<int>(n_);
        width_ = arena_.take<int>(n_);
        joined_ = arena_.take<int>(n_);
        plan_ = {};
        plan_.bodies = n_;
        plan_.position = arena_.take<int>(n_);
        plan_.front_of = arena_.take<int>(n_);
        if (arena_.failed() || !tree_.build(graph_, order_, arena_)) return false;
        for (int i = 0; i < n_; ++i) tree_.for_row(i, [&](int k) { ++below_[std::size_t(k)]; });
        join_columns();
        return number_columns() && find_rows() && find_updates();
    }

  private:
    // joined_[j] = j for the last column of a front, otherwise a later column of the same front.
    void join_columns()
    {
        std::fill(width_.begin(), width_.end(), 1);
        for (int j = 0; j < n_; ++j) {
            const int p = tree_.parent(j);
            joined_[std::size_t(j)] = j;
            if (p < 0) continue;
            const int w = width_[std::size_t(j)], wp = width_[std::size_t(p)];
            const int r = below_[std::size_t(j)], rp = below_[std::size_t(p)];
            if (estimate(w + wp, rp) > estimate(w, r) + estimate(wp, rp)) continue;
            joined_[std::size_t(j)] = p;
            width_[std::size_t(p)] += w;
        }
    }

    bool number_columns()
    {
        int count = 0, rows = 0;
        for (int j = 0; j < n_; ++j)
            if (joined_[std::size_t(j)] == j) ++count, rows += below_[std::size_t(j)];
        plan_.fronts = arena_.take<Front>(count);
        plan_.rows = arena_.take<int>(rows);
        auto front = arena_.take<int>(n_);
        auto next = arena_.take<int>(count);
        if (arena_.failed()) return false;
        int column = 0, s = 0;
        rows = 0;
        std::int64_t block = 0;
        for (int j = 0; j < n_; ++j) {
            if (joined_[std::size_t(j)] != j) continue;
            const int w = width_[std::size_t(j)], r = below_[std::size_t(j)];
            plan_.fronts[std::size_t(s)] = {column, w, r, rows, int(block), 0, 0};
            next[std::size_t(s)] = column;
            front[std::size_t(j)] = s++;
            column += w;
            rows += r;
            block += std::int64_t(w) * (w + r);
        }
        if (block > INT32_MAX / 64) return false;  // 34 million blocks are 10 GB
        plan_.blocks = int(block);
        for (int j = n_ - 1; j >= 0; --j) front[std::size_t(j)] = front[std::size_t(joined_[std::size_t(j)])];
        for (int j = 0; j < n_; ++j) {
            const int at = next[std::size_t(front[std::size_t(j)])]++;
            plan_.position[std::size_t(order_[std::size_t(j)])] = at;
            plan_.front_of[std::size_t(at)] = front[std::size_t(j)];
        }
        return true;
    }

    // Rows in the new order append themselves to the fronts whose last column they are in.
    bool find_rows()
    {
        auto column_of = arena_.take<int>(n_);  // new -> old
        auto fill = arena_.take<int>(int(plan_.fronts.size()));
        if (arena_.failed()) return false;
        for (int j = 0; j < n_; ++j) column_of[std::size_t(position(j))] = j;
        for (std::size_t s = 0; s < fill.size(); ++s) fill[s] = plan_.fronts[s].rows;
        tree_.clear_marks();
        for (int at = 0; at < n_; ++at)
            tree_.for_row(column_of[std::size_t(at)], [&](int k) {
                if (joined_[std::size_t(k)] != k) return;
                const int s = plan_.front_of[std::size_t(position(k))];
                plan_.rows[std::size_t(fill[std::size_t(s)]++)] = at;
            });
        return true;
    }

    int position(int j) const { return plan_.position[std::size_t(order_[std::size_t(j)])]; }

    // Consecutive rows of s that one front owns.
    template <typename Visit>
    void for_targets(const Front& s, Visit visit) const
    {
        const int* rows = plan_.rows.data() + s.rows;
        for (int begin = 0, end; begin < s.below; begin = end) {
            const int target = plan_.front_of[std::size_t(rows[begin])];
            for (end = begin; end < s.below && plan_.front_of[std::size_t(rows[end])] == target;) ++end;
            visit(target, begin, end - begin);
        }
    }

    bool find_updates()
    {
        int updates = 0, places = 0;
        for (Front& s : plan_.fronts) {
            s.updates = updates;
            for_targets(s, [&](int, int begin, int) { ++updates, places += s.below - begin; });
            s.update_count = updates - s.updates;
        }
        plan_.updates = arena_.take<FrontUpdate>(updates);
        plan_.places = arena_.take<int>(places);
        if (arena_.failed()) return false;
        updates = places = 0;
        for (const Front& s : plan_.fronts)
            for_targets(s, [&](int target, int begin, int columns) {
                plan_.updates[std::size_t(updates++)] = {target, begin, columns, places};
                find_places(s, begin, plan_.fronts[std::size_t(target)], places);
                places += s.below - begin;
            });
        return true;
    }

    // Both lists ascend, and the target has every row that s has from there on.
    void find_places(const Front& s, int begin, const Front& target, int place)
    {
        const int* rows = plan_.rows.data() + s.rows;
        const int* theirs = plan_.rows.data() + target.rows;
        int k = 0;
        for (int i = begin; i < s.below; ++i) {
            int at = rows[i] - target.first;
            if (at >= target.width) {
                while (theirs[k] != rows[i]) ++k;
                at = target.width + k;
            }
            plan_.places[std::size_t(place + i - begin)] = at;
        }
    }

    const BodyGraph& graph_;
    std::span<const int> order_;
    Arena& arena_;
    FactorPlan& plan_;
    int n_;
    EliminationTree tree_;
    std::span<int> below_;  // of a column: entries below the diagonal
    std::span<int> width_;  // of the front that ends in the column
    std::span<int> joined_;
};

}  // namespace

int FactorPlan::block_at(int row, int column) const
{
    const Front& f = fronts[std::size_t(front_of[std::size_t(column)])];
    int at = row - f.first;
    if (at >= f.width) {
        const int* first = rows.data() + f.rows;
        at = f.width + int(std::lower_bound(first, first + f.below, row) - first);
    }
    return f.block + at * f.width + (column - f.first);
}

bool make_plan(const BodyGraph& graph, std::span<const int> order, Arena& arena, FactorPlan& out)
{
    return Planner(graph, order, arena, out).make();
}

}  // namespace epode
