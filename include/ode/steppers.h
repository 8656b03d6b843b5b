/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Hybrid steps, which solve each island in its own way, and many worlds in one call. Included by ode/ext.h. */
#ifndef _ODE_STEPPERS_H_
#define _ODE_STEPPERS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a world, or an island of it, is stepped; from the most exact on. */
typedef enum {
    dStepperHybrid,              /**< each island in its own way: as dWorldStepHybrid does */
    dStepperExact,               /**< as dWorldStep does */
    dStepperSubstepsExactJoints, /**< in substeps, with all joints of an island solved together and exactly */
    dStepperSubsteps,            /**< in substeps, as dWorldStepFast1 does; exact joints where sweeps fail */
    dStepperQuick                /**< as dWorldQuickStep does */
} dStepper;

/** @chapter hybrid Hybrid steps

    A hybrid step solves each island in the way that suits it: exactly where that is cheap, in substeps
    where there is a pile, and in substeps with exact joints where articulated bodies stand or lie in a
    pile. Then all joints of the island are solved together, whatever the ratios of masses, and only
    contacts are iterated. The choice follows from the island's structure and from its last steps, never
    from a clock: the same calls give the same bits. dIslandStepReport::method tells what was done;
    docs/solvers.md has the rules.

    Exact rotation, exact substeps and projection (ode/step_options.h) act on islands that are solved
    exactly.

    Arguments:
    - world: the world.
    - body: the body.
    - stepper: one of dStepper.

    Refused: a world or body that is 0 or destroyed; what each function names. Nothing changes then, and the
    answer is 0. */

/** Advances the world by stepsize, s, and chooses the solver of each island. Everything else is as in
    dWorldStep. Returns 1. Refused: a stepsize that is not positive; a call during a step. [ours] */
ODE_API int dWorldStepHybrid(dWorldID world, dReal stepsize);

/** - dWorldSetHybridStepper: Set how hybrid steps solve islands none of whose bodies requests a stepper;
      dStepperHybrid, the default, lets the library choose. Other numbers are refused.
    - dWorldGetHybridStepper: What dWorldSetHybridStepper has set, dStepperHybrid at first. [ours] */
ODE_API void dWorldSetHybridStepper(dWorldID world, int stepper);
ODE_API int dWorldGetHybridStepper(dWorldID world);

/** - dBodySetHybridStepper: Request a stepper for the body's island in hybrid steps; dStepperHybrid, the
      default: none. An island takes the most exact of those that its bodies request. Other numbers are
      refused.
    - dBodyGetHybridStepper: What dBodySetHybridStepper has set, dStepperHybrid at first. [ours] */
ODE_API void dBodySetHybridStepper(dBodyID body, int stepper);
ODE_API int dBodyGetHybridStepper(dBodyID body);

/** - dWorldSetHybridSubsteps: Set how many substeps (count) a hybrid step has where it has any; default 4.
      Values outside 1 ... 10000 are refused.
    - dWorldGetHybridSubsteps: The number that dWorldSetHybridSubsteps has set, 4 at first. [ours] */
ODE_API void dWorldSetHybridSubsteps(dWorldID world, int count);
ODE_API int dWorldGetHybridSubsteps(dWorldID world);

/** - dWorldSetHybridBudget: Set how long the exact solutions of a hybrid step may take together, times what
      substeps of all its islands would (times); default 1. What does not fit takes substeps. The same on every
      machine: work is counted, not timed, and 0.5 ms times `times` are always allowed. Islands whose bodies
      request dStepperExact, and those with couplings, do not count. 0: nothing else is solved exactly;
      dInfinity: whatever the rules of docs/solvers.md choose. Values below 0 are refused.
    - dWorldGetHybridBudget: What dWorldSetHybridBudget has set, 1 at first. [ours] */
ODE_API void dWorldSetHybridBudget(dWorldID world, dReal times);
ODE_API dReal dWorldGetHybridBudget(dWorldID world);

/** @chapter many Many worlds at once

    Worlds know nothing of each other, so each can be stepped on a thread of its own: a learner with a robot
    in each of a hundred worlds, or a search that tries what may come. A world gets the bits that it would
    get alone, whatever worlds are stepped alongside it and however many threads there are. Which worlds
    stay on the caller's thread, and in which order: docs/guide/threads.md. */

/** Makes the given number of steps (at least 1) of stepsize, s, in each of count worlds, with one stepper
    (of dStepper), on at most so many threads, the caller's included (threads 0: one for each processor, at
    most 64). iterations, 1 ... 10000, is the number of substeps of dStepperSubsteps and
    dStepperSubstepsExactJoints. Writes to steps_made, unless it is 0, how many steps each world has made: a
    world that finds no memory stops, the others go on. Returns how many have made them all. Refused, with
    no world changed: worlds that are 0, destroyed, in a step or in the array twice; a null array with a
    count above 0; another stepper; other numbers; a stepsize that is not positive. [ours] */
ODE_API int dWorldsStep(const dWorldID* worlds, int count, dReal stepsize, int stepper, int iterations,
                        int steps, int threads, int* steps_made);

#ifdef __cplusplus
}
#endif

#endif
