/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Impulses, and forces that wake. Included by ode/ext.h. */
#ifndef _ODE_IMPULSES_H_
#define _ODE_IMPULSES_H_

#include <ode/common.h>
#include <ode/queries.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter impulses Impulses and forces that wake

    What a game does to bodies between two steps. All wake the body, as dBodyEnable does. dBodyAddForce and
    its sisters, as in ODE, do not: what they add to a body that sleeps is gone with the next step, and in a
    world with the behaviour of ODE 0.16 (dWorldSetBehaviour) it adds up until the body wakes. Impulses leave
    kinematic bodies alone. All vectors are in the world's frame.

    Arguments:
    - body: the body.
    - pos: where in the world, m; 0: at the centre of mass.

    Refused: a body or a space that is 0 or destroyed; null vectors that may not be null; numbers that are
    not finite; an impulse that would make a velocity infinite; what each function names. Nothing changes
    then, and what returns a number returns 0. */

/** Change the velocities at once: by an impulse (N s), or by its moment alone (N m s).
    - dBodyApplyImpulse: Give the body the impulse at pos, which may be 0: impulse / mass in velocity, and its
      moment about the centre.
    - dBodyApplyAngularImpulse: Give the body the moment. [ours] */
ODE_API void dBodyApplyImpulse(dBodyID body, const dVector3 impulse, const dVector3 pos);
ODE_API void dBodyApplyAngularImpulse(dBodyID body, const dVector3 impulse);

/** Act in the next step, as dBodyAddForceAtPos and dBodyAddTorque do, on a body that is awake from now on.
    - dBodyApplyForce: Add the force (N) at pos, which may be 0.
    - dBodyApplyTorque: Add the torque (N m). [ours] */
ODE_API void dBodyApplyForce(dBodyID body, const dVector3 force, const dVector3 pos);
ODE_API void dBodyApplyTorque(dBodyID body, const dVector3 torque);

/** Set the velocities, linear in m/s and angular in rad/s. Either may be 0: it stays. wake: 1 wakes the body;
    0 does not, as dBodySetLinearVel and dBodySetAngularVel. Refused: another wake. [ours] */
ODE_API void dBodySetVelocities(dBodyID body, const dVector3 linear, const dVector3 angular, int wake);

/** How a radial impulse decreases with the distance r from its centre, up to its radius R. */
typedef enum {
    dFalloffNone,     /**< it does not */
    dFalloffLinear,   /**< 1 - r / R */
    dFalloffQuadratic /**< (1 - r / R)^2 */
} dFalloff;

/** Give an impulse away from center to each body with a geom of the space within radius (m): impulse (N s)
    times what the falloff leaves at the geom's nearest point, there, along the line to the centre of mass.
    A body has it once, at its nearest geom. occlusion 1: only if nothing of another body, and no geom
    without one, is between center and that point; else 0. A null filter finds everything. Returns how many
    bodies had one. Refused: a radius of 0 or below; a dFalloff or an occlusion that is none. [ours] */
ODE_API int dSpaceApplyRadialImpulse(dSpaceID space, const dVector3 center, dReal radius, dReal impulse,
                                     int falloff, int occlusion, const dQueryFilter* filter);

#ifdef __cplusplus
}
#endif

#endif
