// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row by row, i becomes the parent of the roots of all subtrees that contain its earlier neighbours. Paths to
// the roots are compressed while they are walked, which makes the method almost linear.
#include "solve/exact/factor/elimination_tree.h"

#include <algorithm>

namespace epode {

bool EliminationTree::build(const BodyGraph& graph, std::span<const int> order, Arena& arena)
{
    const int n = graph.size();
    graph_ = &graph;
    order_ = order;
    place_ = arena.take<int>(n);
    parent_ = arena.take<int>(n);
    mark_ = arena.take<int>(n);
    if (arena.failed()) return false;
    for (int k = 0; k < n; ++k) place_[std::size_t(order[std::size_t(k)])] = k;
    std::span<int> ancestor = mark_;
    for (int i = 0; i < n; ++i) {
        parent_[std::size_t(i)] = ancestor[std::size_t(i)] = -1;
        for (const int body : graph.of(order[std::size_t(i)])) {
            int j = place_[std::size_t(body)];
            if (j > i) continue;
            while (j >= 0 && j != i) {
                const int up = ancestor[std::size_t(j)];
                ancestor[std::size_t(j)] = i;
                if (up < 0) parent_[std::size_t(j)] = i;
                j = up;
            }
        }
    }
    clear_marks();
    return true;
}

void EliminationTree::clear_marks() { std::fill(mark_.begin(), mark_.end(), -1); }

}  // namespace epode
