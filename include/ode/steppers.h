// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Many worlds in one call. Included by ode/ext.h.
#ifndef _ODE_STEPPERS_H_
#define _ODE_STEPPERS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter many Many worlds at once

    Worlds know nothing of each other, so each can be stepped on a thread of its own: a learner with a robot in
   each of a hundred worlds, a search that tries what may come. A world gets the bits that it would get
   alone, whatever worlds are stepped beside it and however many threads there are. */

/** How a world is stepped. */
typedef enum {
    dStepperExact = 1,  /**< as dWorldStep does */
    dStepperSmallSteps, /**< as dWorldStepFast1 does */
    dStepperQuick       /**< as dWorldQuickStep does */
} dStepper;

/** Makes steps (at least 1) of the given stepsize (s) in each of count worlds, with the stepper (one of
   dStepper), over at most so many threads, the caller's included (threads 0: as many as there are processors,
   at most 64). iterations is that of dWorldStepFast1, 1 ... 10000, for the stepper that has small steps; the
   others do not look at it. Writes to made, unless it is 0, how many steps each of the worlds has made.
   Returns how many worlds have made them all; one that finds no memory stops where it is, after the step that
   it has made last, and the others go on.

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
