// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Small steps of islands that nothing but manifolds holds together (solve/substeps/tgs.cpp has those with
// joints). Nothing asks for poses in between, so bodies are moved once, by the mean of their velocities over
// the substeps; forces, the gyroscopic torque among them, are those of the beginning.
#pragma once

#include "solve/solver.h"

namespace epode {

// False: out of memory.
bool solve_manifolds(RowSystem& system, const SolverSettings& settings, Arena& arena);

}  // namespace epode
