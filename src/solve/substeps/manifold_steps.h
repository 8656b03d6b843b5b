// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Substeps of islands that are held together by contact manifolds only (solve/substeps/tgs.cpp has those with
// joints). Nothing needs poses in between, so bodies are moved once, by the mean of their velocities over the
// substeps. Forces, gyroscopic torques included, are those of the beginning.
#pragma once

#include "solve/solver.h"

namespace epode {

// False: out of memory.
bool solve_manifolds(RowSystem& system, const SolverSettings& settings, Arena& arena);

}  // namespace epode
