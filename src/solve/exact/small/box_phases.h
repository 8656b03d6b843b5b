// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The boxes of the two phases of dWorldStep (direct.cpp), with what the last step's impulses suggest: p
// within its bounds, and a tag per row. Impulses are compared as velocities, d |p|, whose rounding is known.
#pragma once

#include "solve/exact/problem/exact_problem.h"

namespace epode {

// Phase 1: rows with a parent are fixed at 0. True: there are some.
bool bound_without_friction(const ExactProblem& problem, const RowSystem& system, BoxState& state);

// Phase 2: hi = mu |p[parent]|, lo = -hi.
void freeze_friction(const ExactProblem& problem, const RowSystem& system, BoxState& state);

}  // namespace epode
