// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One step of a world, the only place that sees all parts.
#pragma once

#include "dynamics/world.h"
#include "solve/solver.h"
#include "step/contact_cache.h"

namespace epode {

// What survives from one step to the next.
struct StepState {
    ContactCache contacts;
};

// True when the step was made. False: memory was exhausted before anything had been changed.
bool step_world(World& world, const Solver& solver, Real h, int iterations);

}  // namespace epode
