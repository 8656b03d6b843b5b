// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Fluids in a step: their forces enter the accumulators of the awake bodies, with the program's own, before the islands are solved. All are
// computed before any is applied, so that a function of the program may leave the step meanwhile.
#pragma once

#include "dynamics/island.h"
#include "step/common/undo.h"
#include "tasks/tasks.h"

namespace epode {

// Whether a step asks functions of the program about a fluid: they run on the caller's thread.
[[nodiscard]] bool fluids_call_program(const World& world);

// False: out of memory.
[[nodiscard]] bool apply_fluids(World& world, Real h, const Tasks& tasks, StepUndo& undo, Arena& arena);

// The step has been made.
void advance_fluids(World& world, Real h);

// The program has changed a fluid: what sleeps in it, or would be in it now, wakes.
void wake_in_fluids(World& world);

}  // namespace epode
