// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Options of the steppers: threads, warm starting, friction, rotation, substeps, projection. Included by
// ode/ext.h.
#ifndef _ODE_STEP_OPTIONS_H_
#define _ODE_STEP_OPTIONS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter step_options Options of steps

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; numbers that are not finite; what each function
    names. Nothing changes then, and the answer is 0. */

/** - dWorldSetStepThreads: Set over how many threads a step of this world may spread its islands, the
      caller's included; 1 is the default, 0 means as many as the machine has processors, at most 64. A step
      has the same bits on any number of threads. Callbacks run on the caller's thread only; memory handlers
      set by the program may be called from the others. Threads are shared by all worlds, start with the
      first step that wants them and end with the last dCloseODE.
      dWorldSetStepIslandsProcessingMaxThreadCount limits them further. While an implementation is set by
      dWorldSetStepThreadingImplementation, its threads do the work and this number is kept for later.
      Negative numbers are refused.
    - dWorldGetStepThreads: The number that dWorldSetStepThreads has set, 1 at first. [ours] */
ODE_API void dWorldSetStepThreads(dWorldID world, int threads);
ODE_API int dWorldGetStepThreads(dWorldID world);

/** - dWorldSetQuickStepWarmStarting: Set how far a step of the world starts from the constraint forces of
      the last one: factor, 0 ... 1, of each stepper's usual share; default 1, 0 starts from nothing as ODE
      does. Contacts find their forces again although they are new joints in every step. The answer of
      dWorldStep does not depend on it, only the time it takes. Values outside 0 ... 1 are refused.
    - dWorldGetQuickStepWarmStarting: The factor that dWorldSetQuickStepWarmStarting has set, 1 at first.
      [ours] */
ODE_API void dWorldSetQuickStepWarmStarting(dWorldID world, dReal factor);
ODE_API dReal dWorldGetQuickStepWarmStarting(dWorldID world);

/** - dWorldSetContactCone: Set how contact joints bound friction in dWorldQuickStep and dWorldStepFast1.
      mode 0 (the default): as ODE does, each direction by itself, so that a box slides askew with up to 1.41
      times the friction. mode 1: in the plane as a whole, |(f1/l1, f2/l2)| <= 1 with the limits l1 and l2 of
      the two directions (mu times the normal force, or force bounds as the surface flags say), which with
      one mu is Coulomb's cone: the same in every direction, opposite to the slip. Contacts with both
      directions are meant; those with one, or that resist rolling, do not change, nor does dWorldStep, whose
      bounds are those of each row. Contacts that the world manages (ode/contacts.h) always have the cone.
      Costs a root and three divisions per contact and sweep. Other values are refused, as is a call during a
      step.
    - dWorldGetContactCone: The mode that dWorldSetContactCone has set, 0 at first. [ours] */
ODE_API void dWorldSetContactCone(dWorldID world, int mode);
ODE_API int dWorldGetContactCone(dWorldID world);

/** - dWorldSetManifoldFriction: Set how many frictions the points of one contact have in dWorldQuickStep and
      dWorldStepFast1. mode 0 (the default): one for each point. mode 1: one for all points of two bodies
      that follow each other with one normal (up to four), and for each patch of contacts that the world
      manages: a force in the plane at the centre of the normal forces, and a couple about the normal,
      bounded together. With N the sum of the normal forces and rho their mean distance from that centre,
      |f|^2 + (m/rho)^2 <= (mu N)^2: a body that only slides is braked by mu N in every direction, one that
      only turns on its face by mu N rho, one that does both by what an ellipsoid between them allows.
      Contacts that the world manages cost less, contact joints more (up to a fifth of the solver's time,
      since the box of the default needs no roots). Friction is still reported point by point
      (dJointFeedback, impulses of contacts that the world manages): each point has its part by its normal
      force, and these parts add up to the force and couple that acted. Contact joints have it whose mu is
      finite and the same in both directions; those with mu2, with force bounds instead of mu or with an
      infinite one, with one direction or against rolling do not change. Surface motion is kept, slip becomes
      that of all points side by side. dWorldStep, which is exact for each row, does not use it. Other values
      are refused, as is a call during a step.
    - dWorldGetManifoldFriction: The mode that dWorldSetManifoldFriction has set, 0 at first. [ours] */
ODE_API void dWorldSetManifoldFriction(dWorldID world, int mode);
ODE_API int dWorldGetManifoldFriction(dWorldID world);

/** - dWorldSetExactRotation: Set how dWorldStep and dWorldQuickStep turn bodies: mode 0 (the default) as ODE
      does, 1 exactly. Exactly means: the orientation turns by the exponential map, so a spin w held for h
      turns by w h and not by 2 atan(w h/2); and the gyroscopic torque follows the implicit midpoint rule
      with that map, so that a body on which nothing acts keeps its energy and its angular momentum,
      direction included, to rounding (while |w| h < 2 rad; beyond, mostly energy and |L| still). ODE's rule
      damps tumbling away. Bodies under joints or contacts have the same torque in the velocity that the
      constraints start from; the angular velocity that is read of them is that of the middle of the last
      step, which satisfies the constraints; a body on which none has acted reads that of the end. Gyroscopic
      mode off (dBodySetGyroscopicMode) leaves the torque out and keeps the exact turn; a finite rotation
      axis (dBodySetFiniteRotationAxis in finite mode) still splits the turn as the program asked; the
      largest angular speed cuts in as always. In small steps it acts on free bodies; those under joints
      or contacts turn as before. Costs about 0.4 microseconds per body. Other values are refused, as is a
      call during a step.
    - dWorldGetExactRotation: The mode that dWorldSetExactRotation has set, 0 at first. [ours] */
ODE_API void dWorldSetExactRotation(dWorldID world, int mode);
ODE_API int dWorldGetExactRotation(dWorldID world);

/** - dWorldSetExactSubsteps: Set into how many equal parts dWorldStep divides its step; 1 is the default.
      Each part is an exact solve of its own with the poses, joints, stops and rebounds of that moment, while
      contacts stay those that the step began with: their depth follows the motion, one that has opened may
      close but not enter, and a bounce happens in the first part. Forces are held over the step. ERP and CFM
      keep their meaning for the whole step: the parts use those that stand for the same spring and damper,
      so that a spring stays the same spring. Joint feedback is the mean force over the step; damping, sleep
      and callbacks come once. Errors of joints and of free motion fall as in as many steps, with one
      collision instead of n; time grows with n. A projection (dWorldSetStepProjection) follows the last
      part. Values outside 1 ... 1000 are refused.
    - dWorldGetExactSubsteps: The number of parts that dWorldSetExactSubsteps has set, 1 at first. [ours] */
ODE_API void dWorldSetExactSubsteps(dWorldID world, int parts);
ODE_API int dWorldGetExactSubsteps(dWorldID world);

/** - dWorldSetStepProjection: Set how many steps (iterations) of Newton's method on positions may follow
      each dWorldStep, 0 (the default, as in ODE) to 100; 8 are plenty, and most steps take one. dWorldStep
      solves for velocities: at its end joints are open by about (w h)^2/2 of a lever that turns at w, and
      more where a light link carries a heavy load. The projection closes joints (all rows that hold
      positions, and stops that act) until the worst error is below the tolerance, and takes from the depth
      of contacts the share that is their ERP, moving bodies as little as their masses allow. Contacts and
      stops are then not pushed out by velocities, so nothing is thrown off. It never pulls a contact or a
      stop that has opened. It leaves springs alone (rows whose softness, by CFM, is more than a thousandth
      of what the bodies give), motors and friction. Contacts keep the surface layer, and half the tolerance
      so that they are found again. Errors that contradict each other are left at their least squares; a
      Newton step that does not make the errors smaller is shortened, and at last taken back. Velocities are
      not changed. The joints' tension is felt in the inertia of the bodies that they hold, where the step is
      too long to follow how fast it swings them: without that, light links under a heavy load thrash about.
      The step report says what was done. Costs about as much again as the step. Other values are refused.
    - dWorldGetStepProjection: The number of iterations that dWorldSetStepProjection has set, 0 at first.
      [ours] */
ODE_API void dWorldSetStepProjection(dWorldID world, int iterations);
ODE_API int dWorldGetStepProjection(dWorldID world);

/** - dWorldSetStepProjectionTolerance: Set the error (tolerance) that the projection need not remove: of
      angles in rad, of lengths as a share of the longest lever (from the centre of a body to the joint, at
      least its radius of gyration). Default 1e-4 (1e-3 in single precision); values outside 0 ... 1, and
      both ends, are refused.
    - dWorldGetStepProjectionTolerance: The tolerance that dWorldSetStepProjectionTolerance has set; at first
      1e-4, 1e-3 in single precision. [ours] */
ODE_API void dWorldSetStepProjectionTolerance(dWorldID world, dReal tolerance);
ODE_API dReal dWorldGetStepProjectionTolerance(dWorldID world);

#ifdef __cplusplus
}
#endif

#endif
