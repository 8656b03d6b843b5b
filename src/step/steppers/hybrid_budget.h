// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A hybrid step has a budget for exact solutions, summed over its islands: what substeps would take for the
// whole world (dWorldSetHybridBudget times that), so that no step takes more than twice their time, or 0.5 ms
// where that is more. What exact joints add to substeps is taken from it first; islands get parts of the rest:
//
//   1. what was exact in the last step, so that nothing changes to and fro; then what was not, which must leave
//      a quarter of the budget free
//   2. of these, what takes the least: so most islands are exact
//
// and the others take substeps. A part is half as much again as the island took in its last exact step, or a
// guess; what is left is shared. A solution that reaches the end of its part is given up, and the island is
// solved in substeps in the same step: the sum holds whatever the guesses are worth. Everything is counted work
// (solve/common/work_meter.h), hence the same on any machine and any number of threads.
//
// An exact solution gives back what exact joints would add to the substeps of its island. Islands whose joints begin (hybrid.h) have a budget of
// their own, eight times as large, for one step; and figures, for which substeps would do, one of 0.5 ms.
#pragma once

#include "step/steppers/stepper.h"

namespace epode {

// One method for each island. False: out of memory.
[[nodiscard]] bool choose_hybrid_methods(const StepContext& context, std::span<const Island> islands,
                                         Arena& arena, std::span<IslandMethod> methods);

}  // namespace epode
