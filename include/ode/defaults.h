/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Good values for all parameters of a world, in one call, and the version of its behaviour. Included by
 * ode/ext.h. */
#ifndef _ODE_DEFAULTS_H_
#define _ODE_DEFAULTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a world is for. docs/guide/defaults.md has the values of each. */
typedef enum {
    dDefaultsOde,  /**< as ODE begins: the values of a new world */
    dDefaultsGame, /**< piles, stacks, figures, vehicles: steps of 1/60 s, robust and quick, bodies sleep */
    dDefaultsRobot /**< machines and robots: steps of 0.001 to 0.005 s, joints exact, nothing sleeps */
} dDefaults;

/** @chapter defaults Defaults

    One call gives a world the values that docs/guide recommends.

    Refused: a world that is 0 or destroyed; a preset that is none of dDefaults; [dWorldUse] a call during a
    step; [dDefaults] a size below 0, or above 0 without a text. Nothing changes then, and the answer is 0. */

/** Gives every parameter of the world's steps the value of the preset, one of dDefaults; dDefaultsText lists
    them. Step the world by dWorldStepHybrid then, which solves as dWorldSetHybridStepper says; the other
    steppers use the same parameters. Call it before bodies and joints are created, which copy some of the
    values (sleeping, damping, ERP, CFM). Gravity, the space of the contacts, threading functions and modes
    (reports, diagnosis, history, behaviour) stay. Returns 1. [ours] */
ODE_API int dWorldUseDefaults(dWorldID world, int preset);

/** Writes to text, which has size bytes, what dWorldUseDefaults does for the preset: one call a line, in C,
    with the reason. It ends with a zero byte and is cut off where it does not fit; text may be 0 if size is.
    Returns the length of the whole text. [ours] */
ODE_API int dDefaultsText(int preset, char* text, int size);

/** Versions of the behaviour of worlds: a hundred times the major number, plus the minor one. */
typedef enum {
    dBehaviour016 = 16, /**< ODE 0.16, where the two differ in the results of a world and it can be had */
    dBehaviour1 = 100   /**< this library's first, the default */
} dBehaviour;

/** @chapter behaviour Behaviour versions

    What a release changes in the results of a world's steps is kept under the older number, so an upgrade
    changes no finished game. docs/compat.md lists what 0.16 has.

    Refused: a world that is 0 or destroyed; a number that is none of dBehaviour; [dWorldSet] a call during a
    step. Nothing changes then, and the answer is 0. */

/** - dWorldSetBehaviour: Choose how the steps of the world behave: a version of dBehaviour. dBehaviour016:
      dWorldQuickStep sweeps in ODE's order, drawn from dRand, from zero and on one thread (states do not hold
      what dRandGetSeed returns); bodies fall asleep one by one; finite rotations with an axis are ODE's. At
      first dBehaviour1, or what the environment says: EPODE_BEHAVIOUR=0.16 ./program.
    - dWorldGetBehaviour: What dWorldSetBehaviour has set; at first 100 or what the environment says. [ours] */
ODE_API void dWorldSetBehaviour(dWorldID world, int version);
ODE_API int dWorldGetBehaviour(dWorldID world);

#ifdef __cplusplus
}
#endif

#endif
