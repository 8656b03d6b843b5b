// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which column of the factor each column changes first: parent(k) = the first row below the diagonal of
// column k. Row i of the factor has an entry in column k exactly if k lies on the path from some neighbour j
// < i of i upwards before i (Liu, SIAM J. Matrix Anal. Appl. 11, 1990). The paths of row i together are a
// subtree; walking it with marks visits every entry of the row once. Uniting the columns of children instead
// would require sorting them.
#pragma once

#include "solve/exact/factor/body_graph.h"

namespace epode {

class EliminationTree {
  public:
    // order[k] = body eliminated k-th. False: out of memory.
    bool build(const BodyGraph& graph, std::span<const int> order, Arena& arena);

    int size() const { return int(order_.size()); }
    int parent(int k) const { return parent_[std::size_t(k)]; }  // -1: a root
    int place_of(int body) const { return place_[std::size_t(body)]; }

    // Calls visit(k) for the entries of row i left of the diagonal, in no particular order.
    template <typename Visit>
    void for_row(int i, Visit visit)
    {
        mark_[std::size_t(i)] = i;
        for (const int body : graph_->of(order_[std::size_t(i)])) {
            int k = place_[std::size_t(body)];
            if (k > i) continue;
            for (; mark_[std::size_t(k)] != i; k = parent_[std::size_t(k)]) {
                mark_[std::size_t(k)] = i;
                visit(k);
            }
        }
    }

    // Must be called before rows are visited again.
    void clear_marks();

  private:
    const BodyGraph* graph_ = nullptr;
    std::span<const int> order_;
    std::span<int> place_;  // body -> k
    std::span<int> parent_;
    std::span<int> mark_;
};

}  // namespace epode
