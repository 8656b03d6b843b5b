// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Exact methods for islands so small that analysing them would cost more than solving them.
#pragma once

#include "solve/solver.h"

namespace epode {

// kNotSolved: the island is not of this kind, or not to be solved this way; `system` is as it was.
enum class SmallResult { kSolved, kNotSolved, kNoMemory };

// For chains, figures and a few bodies on the ground; tried before all other methods.
SmallResult solve_small(RowSystem& system, const ExactSettings& settings, Arena& arena, SolveReport& report);

// For piles of a few bodies on which the active set did not settle.
bool can_pivot(const RowSystem& system);
SmallResult solve_by_pivoting(RowSystem& system, const ExactSettings& settings, Arena& arena,
                              SolveReport& report);

}  // namespace epode
