// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps and dWorldStepMany (ode/steppers.h). Of the latter the arguments are looked at for all worlds
// before any is touched. A world that is in the array twice shows by the mark that its first place has put on
// it.
#include "base/check.h"
#include "ode/ext.h"
#include "step/batch.h"
#include "step/step.h"

using namespace epode;

namespace {

constexpr int kMostSmallSteps = 10000, kMostThreads = 64;

using MakeStep = bool (*)(World& world, Real h, int iterations);

bool hybrid(World& world, Real h, int) { return step_world_hybrid(world, h); }
bool exact(World& world, Real h, int) { return step_world(world, kDirect, h, 0); }
bool joints_exact(World& world, Real h, int n) { return step_world(world, kNetwork, h, n); }
bool small_steps(World& world, Real h, int n) { return step_world(world, kTgs, h, n); }
bool quick(World& world, Real h, int) { return step_world(world, kQuick, h, world.quick_iterations); }

// Null: there is no such stepper, or not with so many small steps.
MakeStep stepper_of(int stepper, int n)
{
    const bool fits = n >= 1 && n <= kMostSmallSteps;
    switch (stepper) {
        case dStepperHybrid:
            return hybrid;
        case dStepperExact:
            return exact;
        case dStepperJointsExact:
            return fits ? joints_exact : nullptr;
        case dStepperSmallSteps:
            return fits ? small_steps : nullptr;
        case dStepperQuick:
            return quick;
        default:
            return nullptr;
    }
}

bool is_stepper(int number) { return number >= dStepperHybrid && number <= dStepperQuick; }

}  // namespace

extern "C" {

int dWorldStepHybrid(dWorldID w, dReal stepsize)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && usable(stepsize) && stepsize > 0, 0);
    EPODE_USER_SAY(!in_step(*world), "Invalid operation during a step", 0);
    EPODE_USER_SAY(step_world_hybrid(*world, stepsize), kOutOfMemory, 0);
    return 1;
}

void dWorldSetHybridStepper(dWorldID w, int stepper)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && is_stepper(stepper));
    world->hybrid_stepper = stepper;
}

int dWorldGetHybridStepper(dWorldID w)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    return world->hybrid_stepper;
}

void dWorldSetHybridSmallSteps(dWorldID w, int count)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && count >= 1 && count <= kMostSmallSteps);
    world->hybrid_small_steps = count;
}

int dWorldGetHybridSmallSteps(dWorldID w)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    return world->hybrid_small_steps;
}

void dBodySetHybridStepper(dBodyID b, int stepper)
{
    Body* const body = from_handle<Body>(b);
    EPODE_USER(body && is_stepper(stepper));
    body->hybrid.wish = std::uint8_t(stepper);
}

int dBodyGetHybridStepper(dBodyID b)
{
    const Body* const body = from_handle<Body>(b);
    EPODE_USER(body, 0);
    return body->hybrid.wish;
}

int dWorldStepMany(const dWorldID* worlds, int count, dReal stepsize, int stepper, int iterations, int steps,
                   int threads, int* made)
{
    const MakeStep make = stepper_of(stepper, iterations);
    EPODE_USER(make && usable(stepsize) && stepsize > 0 && steps >= 1, 0);
    EPODE_USER(count >= 0 && (worlds || count == 0) && threads >= 0 && threads <= kMostThreads, 0);
    for (int i = 0; i < count; ++i) {
        const World* world = from_handle<World>(worlds[i]);
        EPODE_USER(world, 0);
        EPODE_USER_SAY(!in_step(*world), "Invalid operation during a step", 0);
    }
    WorldBatch batch;
    for (int i = 0; i < count; ++i) {
        World& world = *from_handle<World>(worlds[i]);
        EPODE_USER_SAY(!world.stepping, "a world twice", 0);
        EPODE_USER_SAY(batch.add(world), kOutOfMemory, 0);
    }
    EPODE_USER_SAY(batch.plan(threads), kOutOfMemory, 0);
    const int whole = batch.run({make, stepsize, iterations}, steps, made);
    EPODE_USER_SAY(whole == count, kOutOfMemory, whole);
    return whole;
}

}  // extern "C"
