// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStepMany (ode/steppers.h): arguments are looked at for all worlds before any is touched. A world that
// is in the array twice shows by the mark that its first place has put on it.
#include "base/check.h"
#include "ode/ext.h"
#include "step/batch.h"
#include "step/step.h"

using namespace epode;

namespace {

constexpr int kMostSmallSteps = 10000, kMostThreads = 64;

bool exact(World& world, Real h, int) { return step_world(world, kDirect, h, 0); }
bool small_steps(World& world, Real h, int n) { return step_world(world, kTgs, h, n); }
bool quick(World& world, Real h, int) { return step_world(world, kQuick, h, world.quick_iterations); }

using MakeStep = bool (*)(World& world, Real h, int iterations);

// Null: there is no such stepper, or not with so many iterations.
MakeStep stepper_of(int stepper, int iterations)
{
    switch (stepper) {
        case dStepperExact:
            return exact;
        case dStepperSmallSteps:
            return iterations >= 1 && iterations <= kMostSmallSteps ? small_steps : nullptr;
        case dStepperQuick:
            return quick;
        default:
            return nullptr;
    }
}

}  // namespace

extern "C" int dWorldStepMany(const dWorldID* worlds, int count, dReal stepsize, int stepper, int iterations,
                              int steps, int threads, int* made)
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
