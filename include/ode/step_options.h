/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Options of the steppers: threads, warm starting, friction, rotation, substeps, projection. Included by
 * ode/ext.h; docs/guide/options.md tells when to use them. */
#ifndef _ODE_STEP_OPTIONS_H_
#define _ODE_STEP_OPTIONS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter step_options Options of steps

    What each of them does to a simulation, and what it costs: docs/guide/options.md.

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; numbers that are not finite; what each function names. Nothing
    changes then, and the answer is 0. */

/** - dWorldSetStepThreads: Set the largest number of threads of a step of this world, the caller's
      included; 1 is the default, 0 means one for each processor, at most 64. The bits do not depend on it.
      Callbacks run on the caller's thread, memory handlers on any.
      dWorldSetStepIslandsProcessingMaxThreadCount limits the number further; an implementation set by
      dWorldSetStepThreadingImplementation replaces these threads. Negative numbers are refused.
    - dWorldGetStepThreads: The number that dWorldSetStepThreads has set, 1 at first. [ours] */
ODE_API void dWorldSetStepThreads(dWorldID world, int threads);
ODE_API int dWorldGetStepThreads(dWorldID world);

/** - dWorldSetStepWarmStarting: Set how much of the last step's constraint forces a step starts from:
      factor, 0 ... 1, of each stepper's usual share; default 1, 0 starts from nothing as ODE does. The
      answer of dWorldStep does not depend on it, only its time. Values outside 0 ... 1 are refused.
    - dWorldGetStepWarmStarting: The factor that dWorldSetStepWarmStarting has set, 1 at first. [ours] */
ODE_API void dWorldSetStepWarmStarting(dWorldID world, dReal factor);
ODE_API dReal dWorldGetStepWarmStarting(dWorldID world);

/** - dWorldSetFrictionCone: Choose how the friction of contact joints is bounded. mode 0 (the default): each
      direction by itself, as ODE does. mode 1: both together, |(f1/l1, f2/l2)| <= 1 with the limits l1 and
      l2 of the two directions: with one mu Coulomb's cone. World-managed contacts (ode/contacts.h) always
      have the cone in dWorldStepFast1 and dWorldQuickStep; in dWorldStep they have mode 1, too, and in mode 0
      bounds along their sliding and across. In dWorldStep limits follow in mode 1 from the present normal forces,
      not from those without friction: ladders stand. Refused: other values, a call during a step.
    - dWorldGetFrictionCone: The mode that dWorldSetFrictionCone has set, 0 at first. [ours] */
ODE_API void dWorldSetFrictionCone(dWorldID world, int mode);
ODE_API int dWorldGetFrictionCone(dWorldID world);

/** - dWorldSetManifoldFriction: Choose whether dWorldQuickStep and dWorldStepFast1 bound friction point by
      point (mode 0, the default) or once for all points of a manifold (mode 1): a force at the centre of
      the normal forces and a torque about the normal, bounded together. Feedback and reports still have
      each point's part. Faster for world-managed contacts, slower for contact joints. Other values are
      refused, as is a call during a step.
    - dWorldGetManifoldFriction: The mode that dWorldSetManifoldFriction has set, 0 at first. [ours] */
ODE_API void dWorldSetManifoldFriction(dWorldID world, int mode);
ODE_API int dWorldGetManifoldFriction(dWorldID world);

/** - dWorldSetExactRotation: Choose how bodies under joints and contacts rotate: as ODE rotates them (mode 0, the default) or exactly
      (mode 1, dDefaultsGame and dDefaultsRobot), by the exponential map with the gyroscopic torque of the implicit midpoint rule: a free
      body keeps its energy and angular momentum while it turns by less than 2 rad in a step, a top its precession. A wheel that turns far
      in a step does so about the axis of its hinge, hinge-2, piston, universal or PU joint, and then with what carries it. Bodies on nothing
      rotate exactly in both modes, but with dBehaviour016 in mode 1 only. Other values are refused, as is a call during a step.
    - dWorldGetExactRotation: The mode that dWorldSetExactRotation has set, 0 at first. [ours] */
ODE_API void dWorldSetExactRotation(dWorldID world, int mode);
ODE_API int dWorldGetExactRotation(dWorldID world);

/** - dWorldSetJointCoordinates: Choose whether dWorldStep solves islands of robots in the coordinates of their joints (mode 1, dDefaultsRobot and
      dDefaultsGame) or of their bodies (mode 0, the default): joints stay closed, energy does not drift, rotation is exact, and a robot's step costs a
      fraction. So where most joints are hinges, sliders, balls and fixed ones that have no springs of their own and are closed to the tolerance of
      dWorldSetStepProjection (joints that close loops, and those of other types, are solved with them), bodies turn by less than 2 rad in a step, no
      kinematic body that moves holds a joint, and loads do not make light links swing faster than it follows; contacts, stops, motors and drives may
      act, but where dWorldStepHybrid limits the time of exact steps, no contacts, few bodies and few of the others. Other islands are solved as in mode 0:
      dIslandStepReport::method says how. Other values are refused, as is a call during a step.
    - dWorldGetJointCoordinates: The mode that dWorldSetJointCoordinates has set, 0 at first. [ours] */
ODE_API void dWorldSetJointCoordinates(dWorldID world, int mode);
ODE_API int dWorldGetJointCoordinates(dWorldID world);

/** - dWorldSetExactSubsteps: Set into how many equal substeps (count) dWorldStep divides its step; 1 is the
      default. Each is an exact solve with the poses, joints and stops of that moment, after one collision.
      ERP and CFM keep their meaning for the whole step, forces are held over it, and joint feedback is the
      mean. Errors fall as with as many steps; time grows with their number. Values outside 1 ... 1000 are
      refused.
    - dWorldGetExactSubsteps: The number that dWorldSetExactSubsteps has set, 1 at first. [ours] */
ODE_API void dWorldSetExactSubsteps(dWorldID world, int count);
ODE_API int dWorldGetExactSubsteps(dWorldID world);

/** - dWorldSetStepProjection: Set how many Newton iterations on positions may follow each dWorldStep, 0
      (the default, as in ODE) to 100; 8 are plenty. They close joints until the worst error is below the
      tolerance, and push contacts apart by the share that is their ERP, without changing velocities.
      Springs, motors and friction are left alone. Costs about as much again as the step. Other values are
      refused.
    - dWorldGetStepProjection: The number that dWorldSetStepProjection has set, 0 at first. [ours] */
ODE_API void dWorldSetStepProjection(dWorldID world, int iterations);
ODE_API int dWorldGetStepProjection(dWorldID world);

/** - dWorldSetStepProjectionTolerance: Set the error (tolerance) that the projection need not remove: of
      angles in rad, of lengths as a share of the longest lever (from the centre of a body to the joint, at
      least its radius of gyration). Default 1e-4 (1e-3 in single precision). Values outside 0 ... 1, and
      both ends, are refused.
    - dWorldGetStepProjectionTolerance: The tolerance that dWorldSetStepProjectionTolerance has set; at
      first 1e-4, 1e-3 in single precision. [ours] */
ODE_API void dWorldSetStepProjectionTolerance(dWorldID world, dReal tolerance);
ODE_API dReal dWorldGetStepProjectionTolerance(dWorldID world);

#ifdef __cplusplus
}
#endif

#endif
