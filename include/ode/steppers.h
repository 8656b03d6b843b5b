// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps, which solve each island in its own way, and many worlds in one call. Included by ode/ext.h.
#ifndef _ODE_STEPPERS_H_
#define _ODE_STEPPERS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a world, or an island of it, is stepped; from the most exact on. */
typedef enum {
    dStepperHybrid,      /**< each island in its own way: as dWorldStepHybrid does */
    dStepperExact,       /**< as dWorldStep does */
    dStepperJointsExact, /**< in small steps, with all joints of an island solved together and exactly */
    dStepperSmallSteps,  /**< as dWorldStepFast1 does */
    dStepperQuick        /**< as dWorldQuickStep does */
} dStepper;

/** @chapter hybrid Hybrid steps

    A hybrid step solves each island in the way that suits it: exactly where that is cheap, in small steps
   where there is a heap, and in small steps with exact joints where articulated bodies stand or lie in a
   heap. Then all joints of the island are solved together, whatever the ratios of masses, and only contacts
   are left to iterate; the cost is that of small steps and of a sparse factorisation for each of them. A
   contact knows only the bodies that it touches: a machine whose light feet carry a hundred times their mass
   trembles unless it is solved exactly or in more small steps (10).

    Which it is follows from the island's structure (bodies, joints, contacts, loops, ratio of masses) and
   from what its bodies remember of their last steps, never from a clock: the same calls give the same bits.
   Free bodies and heaps take small steps, or are solved exactly if masses differ by more than 20 and the
   exact solver is reckoned to need less than 0.2 ms; joints without contacts are solved exactly up to 2 ms,
   both together up to 0.2 ms, unless light bodies hang from the world under a load too heavy for the step,
   and else in small steps with exact joints; those that were exact stay so up to twice these times. Joints
   whose factor would not be sparse (a body with dozens of joints) take plain small steps.
   dIslandStepReport::method tells what was done.

    Options of dWorldStep (exact rotation, parts, projection) act on the islands that are solved exactly.

    Arguments:
    - world: the world.
    - body: the body.
    - stepper: one of dStepper.

    Refused: a world or body that is 0 or destroyed; what each function names. Nothing changes then, and the
    answer is 0. */

/** Makes a hybrid step of the given stepsize, s. Everything else is as in dWorldStep. Refused: a stepsize
   that dWorldStep would refuse; a call during a step. [ours] */
ODE_API int dWorldStepHybrid(dWorldID world, dReal stepsize);

/** - dWorldSetHybridStepper: Set how hybrid steps treat islands none of whose bodies asks for a stepper;
      dStepperHybrid, the default, lets the model choose. Other numbers are refused.
    - dWorldGetHybridStepper: What dWorldSetHybridStepper has set, dStepperHybrid at first. [ours] */
ODE_API void dWorldSetHybridStepper(dWorldID world, int stepper);
ODE_API int dWorldGetHybridStepper(dWorldID world);

/** - dBodySetHybridStepper: Set the stepper that the body asks for its island in hybrid steps;
      dStepperHybrid, the default: none. An island takes the most exact of those that its bodies ask for.
      Other numbers are refused.
    - dBodyGetHybridStepper: What dBodySetHybridStepper has set, dStepperHybrid at first. [ours] */
ODE_API void dBodySetHybridStepper(dBodyID body, int stepper);
ODE_API int dBodyGetHybridStepper(dBodyID body);

/** - dWorldSetHybridSmallSteps: Set how many small steps (count) a hybrid step has where it has any; default
      4. Values outside 1 ... 10000 are refused.
    - dWorldGetHybridSmallSteps: The number of small steps that dWorldSetHybridSmallSteps has set, 4 at
      first. [ours] */
ODE_API void dWorldSetHybridSmallSteps(dWorldID world, int count);
ODE_API int dWorldGetHybridSmallSteps(dWorldID world);

/** @chapter many Many worlds at once

    Worlds know nothing of each other, so each can be stepped on a thread of its own: a learner with a robot
   in each of a hundred worlds, a search that tries what may come. A world gets the bits that it would get
   alone, whatever worlds are stepped beside it and however many threads there are. */

/** Makes steps (at least 1) of the given stepsize (s) in each of count worlds, with the stepper (one of
   dStepper), over at most so many threads, the caller's included (threads 0: as many as there are processors,
   at most 64). iterations, 1 ... 10000, is the number of small steps for dStepperSmallSteps and
   dStepperJointsExact; the others do not look at it. Writes to made, unless it is 0, how many steps each of
   the worlds has made. Returns how many worlds have made them all; one that finds no memory stops where it
   is, after the step that it has made last, and the others go on.

    Contacts that a world manages (dWorldSetContactSpace) are found anew in every step; contact joints stay as
   they are, so steps above 1 is for worlds that have none, or for steps so small that they may stay. Forces
   that the program has added act in the first step only.

    A world is stepped by one thread, whatever dWorldSetStepThreads says, but for worlds that stay on the
   caller's. These are worlds with functions of the program, all of which are called on the caller's thread:
   with moved callbacks, with a contact filter, with a threading implementation, or with geoms that ask the
   program (user classes, overridden pairs, functions of meshes and heights, transforms) where steps collide.
   They come after the others, in the order of the array. Worlds that share something a step changes, a space
   with geoms of their bodies or working memory (dWorldUseSharedWorkingMemory), are stepped one after the
   other in the order of the array, all steps of one before the next. Data of meshes and height fields may be
   shared by any number. Functions that give memory are called from all threads.

    Refused, all of it: a world that is 0, destroyed, in a step, or in the array twice; null worlds with a
   count above 0; a negative count or number of threads; another stepper; a stepsize that dWorldStep would
   refuse. No world is changed then, nothing is written, and the answer is 0. [ours] */
ODE_API int dWorldStepMany(const dWorldID* worlds, int count, dReal stepsize, int stepper, int iterations,
                           int steps, int threads, int* made);

#ifdef __cplusplus
}
#endif

#endif
