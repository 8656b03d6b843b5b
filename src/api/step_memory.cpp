// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The working memory of steps for clients: whose functions give it, how much is kept in reserve, which worlds
// share it, and when it is given back. Settings belong to the memory and not to the world: worlds that share
// have one set of them. A block goes back to the partner of the function that gave it, also when the
// functions have been replaced meanwhile.
#include <cmath>

#include "base/check.h"
#include "dynamics/world.h"
#include "step/step.h"

using namespace epode;

namespace {

// `change` on the supply of the world's memory. Going back to a default needs no memory to be made. False:
// out of memory.
template <typename Change>
bool change_supply(World& world, bool to_default, Change&& change)
{
    if (!world.memory && to_default) return true;
    StepMemory* memory = working_memory(world);
    if (!memory) return false;
    ArenaSupply supply = memory->supply();
    change(supply);
    memory->set_supply(supply);
    return true;
}

}  // namespace

extern "C" int dWorldUseSharedWorkingMemory(dWorldID w, dWorldID from_world)
{
    World* const world = from_handle<World>(w);
    World* const from = from_handle<World>(from_world);
    EPODE_USER(world && (from || !from_world) && world != from, 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    EPODE_USER_SAY(!from || !world->memory, "world does already have working memory allocated", 0);
    StepMemory* const memory = from ? working_memory(*from) : nullptr;
    EPODE_USER_SAY(!from || memory, kOutOfMemory, 0);
    StepMemory::let_go(world->memory);
    world->memory = memory ? memory->hold() : nullptr;
    return 1;
}

extern "C" void dWorldCleanupWorkingMemory(dWorldID w)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    free_working_memory(*world);
}

extern "C" int dWorldSetStepMemoryReservationPolicy(dWorldID w, const dWorldStepReserveInfo* policyinfo)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(
        !policyinfo || (policyinfo->struct_size >= sizeof *policyinfo && policyinfo->reserve_factor >= 1 &&
                        std::isfinite(policyinfo->reserve_factor)),
        "Bad policy info", 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    const bool set = change_supply(*world, !policyinfo, [policyinfo](ArenaSupply& supply) {
        const ArenaSupply standard;
        supply.factor = policyinfo ? double(policyinfo->reserve_factor) : standard.factor;
        supply.minimum = policyinfo ? policyinfo->reserve_minimum : standard.minimum;
    });
    EPODE_USER_SAY(set, kOutOfMemory, 0);
    return 1;
}

extern "C" int dWorldSetStepMemoryManager(dWorldID w, const dWorldStepMemoryFunctionsInfo* memfuncs)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(!memfuncs || (memfuncs->struct_size >= sizeof *memfuncs && memfuncs->alloc_block &&
                                 memfuncs->free_block),
                   "Bad memory functions info", 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    const bool set = change_supply(*world, !memfuncs, [memfuncs](ArenaSupply& supply) {
        supply.alloc = memfuncs ? memfuncs->alloc_block : nullptr;
        supply.free = memfuncs ? memfuncs->free_block : nullptr;
    });
    EPODE_USER_SAY(set, kOutOfMemory, 0);
    return 1;
}
