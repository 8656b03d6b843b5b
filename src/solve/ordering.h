// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// In which order to eliminate the bodies of an island so that the factor stays sparse, and the structure that
// the factor then has.
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

// Body pairs that share rows; a == b and repeated pairs are allowed.
struct BodyPair {
    int a, b;
};

// Column j of the factor has its diagonal block and blocks at rows[first[j]] .. rows[first[j+1] - 1], which
// are positions in elimination order, ascending, all greater than j.
struct FactorStructure {
    std::span<int> position;  // body -> place in the elimination order
    std::span<int> first;     // n + 1
    std::span<int> rows;
};

// False: out of memory.
bool order_minimum_degree(int n, std::span<const BodyPair> pairs, Arena& arena, FactorStructure& out);

}  // namespace epode
