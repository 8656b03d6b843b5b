// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/stepping.h"

#include <utility>

#include "joints/breaking.h"
#include "step/common/link.h"

namespace epode {
namespace {

// A function of the program has left the step. Made, it ends without further callbacks. Before, it is taken back; but
// where no body had been stepped yet, the bodies are as the program has seen and perhaps changed them since.
void settle_bodies(World& world, StepState& state)
{
    StepUnderway& step = state.underway;
    if (step.made) return finish_silently(step.unfinished, state.runaways);
    state.contacts.take_back();
    state.runaways.take_back(), state.cut_short.take_back();
    forget_loads(world);
    if (step.ran) step.undo->restore();
    for (Body& body : world.bodies) {
        body.manifolds = nullptr;
        body_stepped(body);
    }
    world.step_count -= step.counted;
}

void abandon_step(World& world, StepState& state)
{
    StepUnderway& step = state.underway;
    settle_bodies(world, state);
    if (Space* const space = state.world_contacts.live_space()) note_geoms_marked(*space);
    world.report_made = state.ledger_made = false;
    if (state.events.list().wants_any()) state.events.lose();
    std::exchange(step.memory, nullptr)->end();
    for (StepObserver* o : state.observers())
        if (o && o->end) o->end(*o, world, step.h, step.made);
}

// Would a step move geoms of a space that is being walked over, or look for pairs in it?
bool moves_locked(World& world, const StepState* state)
{
    const Space* const space = state ? state->world_contacts.live_space() : nullptr;
    if (space && any_locked(*space)) return true;
    for (const Body& body : world.bodies)
        if (in_locked_space(body)) return true;
    return false;
}

}  // namespace

void Stepping::leave(void* id, const void*, std::size_t before)
{
    World& world = *static_cast<World*>(id);
    mark_busy(world, Busy(before));
    if (world.step_state && world.step_state->underway.memory) abandon_step(world, *world.step_state);
}

const char* fault_of_step(World& world)
{
    if (in_step(world)) return busy_text(world);
    // Locks of other threads are not looked for: to step what another thread collides is the program's fault.
    if (!CallGuard::any()) return nullptr;
    CallGuard::release_left();
    if (!CallGuard::any() || !moves_locked(world, world.step_state)) return nullptr;
    return "Invalid operation for locked space: the step would move its geoms or collide it";
}

}  // namespace epode
