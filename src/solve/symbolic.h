// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The structure of the factor of H for an order of elimination.
#pragma once

#include "solve/body_graph.h"

namespace epode {

// Column j of the factor has its diagonal block and blocks at rows[first[j]] .. rows[first[j+1] - 1], which
// are positions in elimination order, ascending, all greater than j.
struct FactorStructure {
    std::span<int> position;  // body -> place in the elimination order
    std::span<int> first;     // n + 1
    std::span<int> rows;
};

// False: out of memory.
bool find_structure(const BodyGraph& graph, std::span<const int> order, Arena& arena, FactorStructure& out);

}  // namespace epode
