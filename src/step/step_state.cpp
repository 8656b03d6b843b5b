// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a world keeps from one step to the next, and its working memory.
#include <new>

#include "step/step.h"

namespace epode {

StepState* step_state(World& world)
{
    if (!world.step_state) {
        void* memory = allocate(sizeof(StepState));
        if (!memory) return nullptr;
        world.step_state = new (memory) StepState;
        world.free_step_state = [](StepState* s) {
            s->~StepState();
            release(s, sizeof(StepState));
        };
    }
    return world.step_state;
}

StepMemory* working_memory(World& world)
{
    if (!world.memory) world.memory = StepMemory::create();
    return world.memory;
}

void free_working_memory(World& world)
{
    if (world.memory) world.memory->free_blocks();
    if (world.step_state) world.step_state->symbolic_cache.clear();
}

void report_unusual(World& world)
{
    if (world.step_state) world.step_state->cut_short.report(world);
    // Its handler may have destroyed the world.
    if (world.step_state) world.step_state->runaways.report(world);
}

std::span<const dIslandStepReport> island_reports(const World& world)
{
    if (!world.report_made || !world.step_state) return {};
    return world.step_state->reports.span();
}

}  // namespace epode
