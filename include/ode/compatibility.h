/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Names of earlier releases, for programs written from the 0.039 user guide: the rotation
 * conversions under their old names, the StepFast1 stepper and its automatic disabling. They all
 * work; what each does in today's terms stands beside it. (The capped-cylinder names are in
 * collision.h and mass.h.) */
#ifndef _ODE_COMPATIBILITY_H_
#define _ODE_COMPATIBILITY_H_

#include <ode/common.h>

/** Old names of dRfromQ, dQfromR, dDQfromW; note the order of the arguments. */
#define dQtoR(q, R) dRfromQ((R), (q))
#define dRtoQ(R, q) dQfromR((q), (R))
#define dWtoDQ(w, q, dq) dDQfromW((dq), (w), (q))

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter old_names Names of the 0.039 guide

    What programs written from the user guide of ODE 0.039 call and ODE 0.16 no longer has. Beside these,
    collision.h keeps dCreateCCylinder and its relatives, mass.h dMassSetCappedCylinder.

    Arguments:
    - w: a world.
    - b: a body.

    Refused: a world or body that is 0 or destroyed; numbers that are not finite. Nothing changes then, and
    getters answer 0. */

/** Advance the world by stepsize seconds with the small-step solver: the step is cut into maxiterations
    (1 ... 10000) equal small steps, and in each of them every joint is solved on its own as a rigid block.
    Time and memory grow linearly with the number of joints. More iterations give more accuracy; joint ERP and
    CFM keep the meaning they have for the whole step. May be mixed freely with dWorldStep and
    dWorldQuickStep on the same world. Returns 1 when the world was stepped, 0 when the call was refused
    (null world, stepsize not positive and finite, maxiterations outside 1 ... 10000) or out of memory: poses,
    velocities and accumulators are then as they were. [guide] */
ODE_API int dWorldStepFast1(dWorldID w, dReal stepsize, int maxiterations);

/** - dWorldSetAutoEnableDepthSF1: Store the world's autoEnableDepth of the guide. It changes nothing: waking
      through joints always reaches the whole island.
    - dWorldGetAutoEnableDepthSF1: The number that dWorldSetAutoEnableDepthSF1 has stored. [guide] */
ODE_API void dWorldSetAutoEnableDepthSF1(dWorldID w, int autoEnableDepth);
ODE_API int dWorldGetAutoEnableDepthSF1(dWorldID w);

/** - dBodySetAutoDisableThresholdSF1: Old form that sets both thresholds of idleness to
      autoDisableThreshold: the linear one, m/s, and the angular one, rad/s.
    - dBodyGetAutoDisableThresholdSF1: The body's threshold of the linear speed, m/s: old name of
      dBodyGetAutoDisableLinearThreshold.
    - dBodySetAutoDisableStepsSF1: Old name of dBodySetAutoDisableSteps; AutoDisableSteps is the number of
      idle steps.
    - dBodyGetAutoDisableStepsSF1: Old name of dBodyGetAutoDisableSteps.
    - dBodySetAutoDisableSF1: Old name of dBodySetAutoDisableFlag; doAutoDisable not 0 switches it on.
    - dBodyGetAutoDisableSF1: Old name of dBodyGetAutoDisableFlag. [guide] */
ODE_API void dBodySetAutoDisableThresholdSF1(dBodyID b, dReal autoDisableThreshold);
ODE_API dReal dBodyGetAutoDisableThresholdSF1(dBodyID b);
ODE_API void dBodySetAutoDisableStepsSF1(dBodyID b, int AutoDisableSteps);
ODE_API int dBodyGetAutoDisableStepsSF1(dBodyID b);
ODE_API void dBodySetAutoDisableSF1(dBodyID b, int doAutoDisable);
ODE_API int dBodyGetAutoDisableSF1(dBodyID b);

#ifdef __cplusplus
}
#endif

#endif
