// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row i of the factor has an entry in column k exactly if, in the elimination tree, k lies on the path from
// some neighbour j < i of i upwards before i (Liu, SIAM J. Matrix Anal. Appl. 11, 1990). The paths of row i
// together are a subtree; walking it with marks visits every entry once. Rows come in ascending order, so
// the columns come out sorted. Once to count, once to fill; uniting the columns of children instead would
// have to sort them.
#include "solve/symbolic.h"

#include <algorithm>

namespace epode {
namespace {

class RowPaths {
  public:
    bool prepare(const BodyGraph& graph, std::span<const int> order, std::span<const int> position,
                 Arena& arena)
    {
        graph_ = &graph;
        order_ = order;
        position_ = position;
        parent_ = arena.take<int>(graph.size());
        ancestor_ = arena.take<int>(graph.size());
        if (arena.failed()) return false;
        find_parents();
        return true;
    }

    // visit(i, k) for every entry below the diagonal, rows ascending.
    template <typename Visit>
    void for_entries(Visit visit)
    {
        std::span<int> mark = ancestor_;
        std::fill(mark.begin(), mark.end(), -1);
        for (int i = 0; i < graph_->size(); ++i) {
            mark[std::size_t(i)] = i;
            for_earlier_neighbours(i, [&](int j) {
                for (int k = j; mark[std::size_t(k)] != i; k = parent_[std::size_t(k)]) {
                    mark[std::size_t(k)] = i;
                    visit(i, k);
                }
            });
        }
    }

  private:
    template <typename Visit>
    void for_earlier_neighbours(int i, Visit visit) const
    {
        for (const int body : graph_->of(order_[std::size_t(i)]))
            if (position_[std::size_t(body)] < i) visit(position_[std::size_t(body)]);
    }

    // i is the parent of the roots of all subtrees that it touches; paths to the roots are shortened as they
    // are walked.
    void find_parents()
    {
        for (int i = 0; i < graph_->size(); ++i) {
            parent_[std::size_t(i)] = ancestor_[std::size_t(i)] = -1;
            for_earlier_neighbours(i, [&](int j) {
                while (j >= 0 && j != i) {
                    const int up = ancestor_[std::size_t(j)];
                    ancestor_[std::size_t(j)] = i;
                    if (up < 0) parent_[std::size_t(j)] = i;
                    j = up;
                }
            });
        }
    }

    const BodyGraph* graph_ = nullptr;
    std::span<const int> order_, position_;
    std::span<int> parent_;    // in the elimination tree, -1: a root
    std::span<int> ancestor_;  // shortened paths, afterwards marks
};

}  // namespace

bool find_structure(const BodyGraph& graph, std::span<const int> order, Arena& arena, FactorStructure& out)
{
    const int n = graph.size();
    out.position = arena.take<int>(n);
    out.first = arena.take_zeroed<int>(n + 1);
    auto fill = arena.take<int>(n);
    RowPaths paths;
    if (arena.failed()) return false;
    for (int k = 0; k < n; ++k) out.position[std::size_t(order[std::size_t(k)])] = k;
    if (!paths.prepare(graph, order, out.position, arena)) return false;

    paths.for_entries([&](int, int k) { ++out.first[std::size_t(k) + 1]; });
    for (int k = 0; k < n; ++k) {
        fill[std::size_t(k)] = out.first[std::size_t(k)];
        out.first[std::size_t(k) + 1] += out.first[std::size_t(k)];
    }
    out.rows = arena.take<int>(out.first[std::size_t(n)]);
    if (arena.failed()) return false;
    paths.for_entries([&](int i, int k) { out.rows[std::size_t(fill[std::size_t(k)]++)] = i; });
    return true;
}

}  // namespace epode
