// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One step of a world, the only place that sees all parts.
#pragma once

#include "base/array.h"
#include "contacts/contact_world.h"
#include "dynamics/world.h"
#include "solve/exact/factor/symbolic_cache.h"
#include "solve/solver.h"
#include "step/contact_cache.h"
#include "step/continuous.h"

namespace epode {

// What survives from one step to the next.
struct StepState {
    ContactCache contacts;
    SymbolicCache symbolic_cache;
    ContinuousLists continuous;
    ContactWorld world_contacts;       // contacts that the world finds by itself
    Array<dIslandStepReport> reports;  // of the last step's islands, when they were wanted
};

// In its own step, or its working memory in that of another world.
inline bool in_step(const World& world) { return world.stepping || (world.memory && world.memory->in_use()); }

// The world's working memory, made now if it has none; null when memory is exhausted.
StepMemory* working_memory(World& world);

// Gives back what the world's next step can make anew.
void free_working_memory(World& world);

// True when the step was made. False: memory was exhausted or another step is using it; the world is as if
// there had been no step, but for the feedback of joints and the report.
bool step_world(World& world, const Solver& solver, Real h, int iterations);

inline constexpr int kMaxSubsteps = 10000;

// The same with a solver for each island (step/hybrid).
bool step_world_hybrid(World& world, Real h);

// What the world keeps from step to step, made now if there is none; null when memory is exhausted.
StepState* step_state(World& world);

// Of the last step; empty when no report was made.
std::span<const dIslandStepReport> island_reports(const World& world);

}  // namespace epode
