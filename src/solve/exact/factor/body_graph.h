// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which bodies of an island share rows: the sparsity of H = M + J^T D J in units of 6x6 blocks. All joints
// and contacts between two bodies are one edge; rows on one body alone are none. Neighbours are in ascending
// order, so two islands with the same edges have the same graph, word by word, in whatever order their joints
// were created.
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

// Body pairs that share rows; a == b and repeated pairs are allowed.
struct BodyPair {
    int a, b;
};

// The neighbours of v are neighbour[first[v]] .. neighbour[first[v + 1] - 1]; every edge is stored twice.
struct BodyGraph {
    std::span<int> first;  // n + 1
    std::span<int> neighbour;

    int size() const { return int(first.size()) - 1; }
    std::span<const int> of(int v) const
    {
        const auto begin = std::size_t(first[std::size_t(v)]);
        return neighbour.subspan(begin, std::size_t(first[std::size_t(v) + 1]) - begin);
    }
};

// False: out of memory.
bool build_body_graph(int n, std::span<const BodyPair> pairs, Arena& arena, BodyGraph& out);

}  // namespace epode
