// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One step of a world, the only place that sees all parts.
#pragma once

#include "base/array.h"
#include "dynamics/world.h"
#include "solve/plan_cache.h"
#include "solve/solver.h"
#include "step/contact_cache.h"

namespace epode {

// What survives from one step to the next.
struct StepState {
    ~StepState();

    ContactCache contacts;
    PlanCache plans;
    Array<Arena*> arenas;              // of the workers besides the caller, who takes the world's
    Array<dIslandStepReport> reports;  // of the last step's islands, when they were wanted
};

// True when the step was made. False: memory was exhausted before anything had been changed.
bool step_world(World& world, const Solver& solver, Real h, int iterations);

// Of the last step; empty when no report was made.
std::span<const dIslandStepReport> island_reports(const World& world);

}  // namespace epode
