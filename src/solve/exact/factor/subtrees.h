// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which parts of a large tree of fronts can be worked on at the same time.
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

// Children come before their parents.
struct FrontTree {
    std::span<int> parent;     // -1: a root
    std::span<double> weight;  // time of each front alone, solve/exact/factor/symbolic.cpp's unit
};

// subtree_of[s] = the subtree that front s is in, 0 .. count - 1, or -1: above them all, or not worth it.
// False: out of memory.
bool cut_subtrees(const FrontTree& tree, Arena& arena, std::span<int>& subtree_of, int& count);

}  // namespace epode
