// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps and dWorldsStep (ode/steppers.h). Of the latter the arguments are looked at for all worlds
// before any is touched. A world that is in the array twice shows by the mark that its first place has put on
// it.
#include "base/check.h"
#include "ode/ext.h"
#include "step/batch.h"
#include "step/step.h"
#include "step/steppers/stepper.h"

using namespace epode;

namespace {

constexpr int kMaxThreads = 64;

}  // namespace

extern "C" {

int dWorldStepHybrid(dWorldID w, dReal stepsize)
{
    World* const world = from_handle<World>(w);
    EPODE_USER(world && usable(stepsize) && stepsize > 0, 0);
    EPODE_MAY_STEP(*world);
    EPODE_USER_SAY(step_world(*world, kHybrid, stepsize, 0), kOutOfMemory, 0);
    report_unusual(*world);
    return 1;
}

int dWorldsStep(const dWorldID* worlds, int count, dReal stepsize, int stepper, int iterations, int steps,
                int threads, int* steps_made)
{
    EPODE_USER(is_stepper(stepper) && usable(stepsize) && stepsize > 0 && steps >= 1, 0);
    const Stepper& how = *stepper_numbered(stepper);
    EPODE_USER(!how.has_substeps || (iterations >= 1 && iterations <= kMaxSubsteps), 0);
    EPODE_USER(count >= 0 && (worlds || count == 0) && threads >= 0 && threads <= kMaxThreads, 0);
    for (int i = 0; i < count; ++i) {
        World* const world = from_handle<World>(worlds[i]);
        EPODE_USER(world, 0);
        EPODE_MAY_STEP(*world);
    }
    int whole = 0;
    const char* wrong =
        nullptr;  // for when the worlds are no longer marked: a message handler may not return
    {
        WorldBatch batch;
        for (int i = 0; i < count && !wrong; ++i) {
            World& world = *from_handle<World>(worlds[i]);
            wrong = world.busy != Busy::kNo ? "a world twice" : batch.add(world) ? nullptr : kOutOfMemory;
        }
        if (!wrong && !batch.prepare(threads)) wrong = kOutOfMemory;
        if (!wrong) whole = batch.run({how, stepsize, iterations}, steps, steps_made);
    }
    EPODE_USER_SAY(!wrong, wrong, 0);
    EPODE_USER_SAY(whole == count, kOutOfMemory, whole);
    for (int i = 0; i < count; ++i)  // an earlier message's handler may have destroyed it
        if (World* world = from_handle<World>(worlds[i])) report_unusual(*world);
    return whole;
}

}  // extern "C"
