// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 1. Lengths of the columns, from the elimination tree.
// 2. Fronts. From the leaves up, the front that ends in column j is joined to that of its parent if an
//    estimate of time says so: longer inner products against arithmetic on blocks that are zero. The rows of
//    a front are those of its last column.
// 3. Large trees are cut into subtrees (solve/exact/factor/subtrees.h).
// 4. Columns are renumbered, front by front, each front in the place of its last column. Children stay before
//    parents, so the fill does not change. Branches of the tree alternate as in the order of elimination; the
//    processor then overlaps their arithmetic, which within a branch is a chain of dependent operations.
// 5. The rows of the fronts, in ascending order, and where their products go.
#include "solve/exact/factor/symbolic.h"

#include <algorithm>
#include <cstdint>

#include "solve/exact/factor/elimination_tree.h"
#include "solve/exact/factor/subtrees.h"

namespace epode {
namespace {

// Time of a front, in units of one 6x6 times 6x6 product: its products, and half a unit for each block that
// it has or subtracts from. Measured on walls, piles and ladders; with three times as much or nothing for the
// blocks a step takes a few per cent longer.
double estimate(double width, double below)
{
    constexpr double kTouch = 0.5;
    const double outer = below * (below + 1) / 2;
    const double products = width * (outer + (width + 1) * (below / 2 + (width + 2) / 6));
    return products + kTouch * (outer + width * (width + below));
}

class SymbolicAnalysis {
  public:
    SymbolicAnalysis(const BodyGraph& graph, std::span<const int> order, Arena& arena, SymbolicFactor& out)
        : graph_(graph), order_(order), arena_(arena), symbolic_(out), n_(graph.size())
    {}

    bool make()
    {
        below_ = arena_.take_zeroed<int>(n_);
        width_ = arena_.take<int>(n_);
        joined_ = arena_.take<int>(n_);
        symbolic_ = {};
        symbolic_.bodies = symbolic_.columns = n_;
        symbolic_.position = arena_.take<int>(n_);
        symbolic_.front_of = arena_.take<int>(n_);
        if (arena_.failed() || !tree_.build(graph_, order_, arena_)) return false;
        for (int i = 0; i < n_; ++i) tree_.for_row(i, [&](int k) { ++below_[std::size_t(k)]; });
        join_columns();
        return make_tree() && cut_subtrees(front_tree_, arena_, subtree_of_, subtree_count_) &&
               number_fronts() && number_columns() && find_rows() && find_updates() && list_subtrees();
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

    // Fronts in the order of their last columns, with their parents.
    bool make_tree()
    {
        int count = 0;
        for (int j = 0; j < n_; ++j) count += joined_[std::size_t(j)] == j;
        last_ = arena_.take<int>(count);
        front_ = arena_.take<int>(n_);
        front_tree_.parent = arena_.take<int>(count);
        front_tree_.weight = arena_.take<double>(count);
        if (arena_.failed()) return false;
        int s = 0;
        for (int j = 0; j < n_; ++j) {
            if (joined_[std::size_t(j)] != j) continue;
            front_[std::size_t(j)] = s;
            last_[std::size_t(s++)] = j;
        }
        for (int j = n_ - 1; j >= 0; --j)
            front_[std::size_t(j)] = front_[std::size_t(joined_[std::size_t(j)])];
        for (s = 0; s < count; ++s) {
            const auto at = std::size_t(s), j = std::size_t(last_[at]);
            const int above = tree_.parent(last_[at]);
            front_tree_.parent[at] = above < 0 ? -1 : front_[std::size_t(above)];
            front_tree_.weight[at] = estimate(width_[j], below_[j]);
        }
        return true;
    }

    // Fronts of subtrees first, then the others, each in the order of elimination; then the borders.
    bool number_fronts()
    {
        const int count = int(last_.size());
        auto index = arena_.take<int>(count);
        auto last = arena_.take<int>(count);
        symbolic_.fronts = arena_.take<Front>(count + subtree_count_);
        symbolic_.subtrees = arena_.take<Subtree>(subtree_count_);
        if (arena_.failed()) return false;
        int next = 0;
        for (const bool inside : {true, false}) {
            if (!inside) symbolic_.top = next;
            for (int s = 0; s < count; ++s)
                if ((subtree_of_[std::size_t(s)] >= 0) == inside) index[std::size_t(s)] = next++;
        }
        symbolic_.end = count;
        auto of = arena_.take<int>(count);
        if (arena_.failed()) return false;
        for (std::size_t s = 0; s < last_.size(); ++s) {
            last[std::size_t(index[s])] = last_[s];
            of[std::size_t(index[s])] = subtree_of_[s];
        }
        for (int& s : front_) s = index[std::size_t(s)];
        last_ = last;
        subtree_of_ = of;
        return true;
    }

    bool number_columns()
    {
        std::int64_t rows = 0, block = 0;
        int column = 0;
        auto next = arena_.take<int>(symbolic_.end);
        if (arena_.failed()) return false;
        for (int s = 0; s < symbolic_.end; ++s) {
            const auto j = std::size_t(last_[std::size_t(s)]);
            const int w = width_[j], r = below_[j];
            symbolic_.fronts[std::size_t(s)] = {column, w, r, int(rows), int(block), 0, 0};
            next[std::size_t(s)] = column;
            column += w;
            rows += r;
            block += std::int64_t(w) * (w + r);
            if (subtree_of_[std::size_t(s)] >= 0)  // the last front of a subtree is its root
                symbolic_.subtrees[std::size_t(subtree_of_[std::size_t(s)])].root = s;
        }
        for (int t = 0; t < subtree_count_; ++t) {
            const int root = symbolic_.subtrees[std::size_t(t)].root,
                      w = symbolic_.fronts[std::size_t(root)].below;
            symbolic_.subtrees[std::size_t(t)].border = symbolic_.end + t;
            symbolic_.fronts[std::size_t(symbolic_.end + t)] = {symbolic_.columns, w, 0, 0, int(block), 0, 0};
            symbolic_.columns += w;
            block += std::int64_t(w) * w;
        }
        if (block > INT32_MAX / 64) return false;  // 34 million blocks are 10 GB
        symbolic_.blocks = int(block);
        symbolic_.rows = arena_.take<int>(int(rows));
        if (subtree_count_) symbolic_.entries = arena_.take<int>(int(rows));
        if (arena_.failed()) return false;
        for (int j = 0; j < n_; ++j) {
            const int s = front_[std::size_t(j)], at = next[std::size_t(s)]++;
            symbolic_.position[std::size_t(order_[std::size_t(j)])] = at;
            symbolic_.front_of[std::size_t(at)] = s;
        }
        return true;
    }

    // Rows, in the new order, append themselves to the fronts whose last column they are in.
    bool find_rows()
    {
        auto column_of = arena_.take<int>(n_);  // new -> old
        auto fill = arena_.take<int>(symbolic_.end);
        if (arena_.failed()) return false;
        for (int j = 0; j < n_; ++j)
            column_of[std::size_t(symbolic_.position[std::size_t(order_[std::size_t(j)])])] = j;
        for (std::size_t s = 0; s < fill.size(); ++s) fill[s] = symbolic_.fronts[s].rows;
        tree_.clear_marks();
        for (int at = 0; at < n_; ++at)
            tree_.for_row(column_of[std::size_t(at)], [&](int k) {
                if (joined_[std::size_t(k)] == k)
                    symbolic_.rows[std::size_t(fill[std::size_t(front_[std::size_t(k)])]++)] = at;
            });
        std::copy_n(symbolic_.rows.begin(), symbolic_.entries.size(), symbolic_.entries.begin());
        return true;
    }

    // Consecutive rows of s that belong to one front; within a subtree the border receives all rows outside.
    template <typename Visit>
    void for_targets(int s, bool as_border, Visit visit) const
    {
        const Front& f = symbolic_.fronts[std::size_t(s)];
        const int* rows = symbolic_.rows.data() + f.rows;
        for (int begin = 0, end; begin < f.below; begin = end) {
            int target = symbolic_.front_of[std::size_t(rows[begin])];
            if (s < symbolic_.top && target >= symbolic_.top && !as_border) {
                end = f.below;
                target = symbolic_.end + subtree_of_[std::size_t(s)];
            } else {
                for (end = begin; end < f.below && symbolic_.front_of[std::size_t(rows[end])] == target;)
                    ++end;
            }
            visit(target, begin, end - begin);
        }
    }

    bool find_updates()
    {
        int updates = 0, places = 0;
        for (int s = 0; s < int(symbolic_.fronts.size()); ++s) {
            const int from = s < symbolic_.end ? s : symbolic_.subtrees[std::size_t(s - symbolic_.end)].root;
            const int rows = symbolic_.fronts[std::size_t(from)].below;
            Front& f = symbolic_.fronts[std::size_t(s)];
            f.updates = updates;
            for_targets(from, s >= symbolic_.end,
                        [&](int, int begin, int) { ++updates, places += rows - begin; });
            f.update_count = updates - f.updates;
        }
        symbolic_.updates = arena_.take<FrontUpdate>(updates);
        symbolic_.places = arena_.take<int>(places);
        if (arena_.failed()) return false;
        updates = places = 0;
        for (int s = 0; s < int(symbolic_.fronts.size()); ++s) {
            const int from = s < symbolic_.end ? s : symbolic_.subtrees[std::size_t(s - symbolic_.end)].root;
            const Front& f = symbolic_.fronts[std::size_t(from)];
            for_targets(from, s >= symbolic_.end, [&](int target, int begin, int columns) {
                symbolic_.updates[std::size_t(updates++)] = {target, begin, columns, places};
                target < symbolic_.end ? find_places(f, begin, symbolic_.fronts[std::size_t(target)], places)
                                       : find_border_places(f, begin, target, places);
                places += f.below - begin;
            });
        }
        return true;
    }

    // Both lists ascend, and the target has every row that s has from there on.
    void find_places(const Front& s, int begin, const Front& target, int place)
    {
        const int* rows = symbolic_.rows.data() + s.rows;
        const int* theirs = symbolic_.rows.data() + target.rows;
        int k = 0;
        for (int i = begin; i < s.below; ++i) {
            int at = rows[i] - target.first;
            if (at >= target.width) {
                while (theirs[k] != rows[i]) ++k;
                at = target.width + k;
            }
            symbolic_.places[std::size_t(place + i - begin)] = at;
        }
    }

    void find_border_places(const Front& s, int begin, int border, int place)
    {
        const Front& root =
            symbolic_.fronts[std::size_t(symbolic_.subtrees[std::size_t(border - symbolic_.end)].root)];
        const int* rows = symbolic_.rows.data() + s.rows;
        const int* theirs = symbolic_.rows.data() + root.rows;
        int k = 0;
        for (int i = begin; i < s.below; ++i) {
            while (theirs[k] != rows[i]) ++k;
            symbolic_.places[std::size_t(place + i - begin)] = k;
            symbolic_.entries[std::size_t(s.rows + i)] = symbolic_.fronts[std::size_t(border)].first + k;
        }
    }

    bool list_subtrees()
    {
        symbolic_.subtree_fronts = arena_.take<int>(symbolic_.top);
        if (arena_.failed()) return false;
        int next = 0;
        for (int t = 0; t < subtree_count_; ++t) {
            Subtree& subtree = symbolic_.subtrees[std::size_t(t)];
            subtree.fronts = next;
            for (int s = 0; s < symbolic_.top; ++s)
                if (subtree_of_[std::size_t(s)] == t) symbolic_.subtree_fronts[std::size_t(next++)] = s;
            subtree.count = next - subtree.fronts;
        }
        return true;
    }

    const BodyGraph& graph_;
    std::span<const int> order_;
    Arena& arena_;
    SymbolicFactor& symbolic_;
    int n_;
    EliminationTree tree_;
    std::span<int> below_;  // of a column: entries below the diagonal
    std::span<int> width_;  // of the front that ends in the column
    std::span<int> joined_;
    std::span<int> front_;       // column -> front
    std::span<int> last_;        // front -> its last column
    std::span<int> subtree_of_;  // front -> subtree or -1
    FrontTree front_tree_;
    int subtree_count_ = 0;
};

}  // namespace

int SymbolicFactor::block_at(int row, int column) const
{
    const Front& f = fronts[std::size_t(front_of[std::size_t(column)])];
    int at = row - f.first;
    if (at >= f.width) {
        const int* first = rows.data() + f.rows;
        at = f.width + int(std::lower_bound(first, first + f.below, row) - first);
    }
    return f.block + at * f.width + (column - f.first);
}

bool factor_symbolically(const BodyGraph& graph, std::span<const int> order, Arena& arena,
                         SymbolicFactor& out)
{
    return SymbolicAnalysis(graph, order, arena, out).make();
}

}  // namespace epode
