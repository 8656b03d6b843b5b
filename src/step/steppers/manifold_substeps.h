// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Substeps of islands that are held together by contact manifolds only (step/steppers/substep_loop.h has those with
// rows). Nothing needs poses in between, so bodies are moved once, by the mean of their velocities over the
// substeps. Forces, gyroscopic torques included, are those of the beginning.
#pragma once

#include "step/island/substep_model.h"

namespace epode {

// `ends`: as in make_substeps. False: out of memory.
bool make_manifold_substeps(RowSystem& system, SubstepModel& model, int n, const Tasks& tasks,
                            std::span<Velocity> ends, Arena& arena);

}  // namespace epode
