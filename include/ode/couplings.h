/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Couplings: linear relations between the coordinates of several joints. Included by ode/ext.h. */
#ifndef _ODE_COUPLINGS_H_
#define _ODE_COUPLINGS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter couplings Couplings: mimic joints, gears, differentials, tendons

    A coupling is a joint between joints. With the positions q of up to eight axes (dJointGetAxisPosition) and
    a factor a for each, its own position is

        s = a_0 q_0 + a_1 q_1 + ...

    and it holds s at a place or between two stops. It has no bodies of its own, but one axis, number 0, whose
    position is s: stops, springs, drives, breaking limits, dJointEnable and dJointSetFeedback work on it as
    on any joint. Its two stops are 0 at first, which holds s = 0 rigidly. A force f along s acts on axis i
    with a_i f, also in the dJointFeedback of the joint that has the axis; its own dJointFeedback stays zero.

    It acts while all its joints are attached and enabled. If one of them is destroyed, its place becomes
    empty and the coupling is disabled. Angles count turns from the moment they are coupled
    (dJointSetAxisContinuous).

    Arguments:
    - coupling: a coupling.
    - i: one of its places, 0 ... dMaxCouplingAxes - 1.

    Refused: a joint that is 0, destroyed or no coupling; a place out of range; what each function names; a
    change during a step. Nothing changes then, and the answer is 0. */

/** Places for axes in a coupling. */
enum { dMaxCouplingAxes = 8 };

/** Create a relation between joints that has no axes yet, in the world, in the group or alone. [ours] */
ODE_API dJointID dJointCreateCoupling(dWorldID world, dJointGroupID group);

/** - dJointSetCouplingAxis: Let the position of an axis count factor times, in place i; joint 0 empties the
      place. Wakes the bodies. Another factor for the axis that a place has is, from then on, part of the
      world's state, not of its structure. Returns 1, or 0 when refused: a coupling or a joint of another
      world as joint; an axis that it does not have; a factor that is 0 or not finite; or out of memory.
    - dJointGetCouplingJoint: Returns the joint in place i, 0 if the place is empty.
    - dJointGetCouplingAxis: Returns the number of its axis, 0 if the place is empty.
    - dJointGetCouplingFactor: Returns its factor, 0 if the place is empty. [ours] */
ODE_API int dJointSetCouplingAxis(dJointID coupling, int i, dJointID joint, int axis, dReal factor);
ODE_API dJointID dJointGetCouplingJoint(dJointID coupling, int i);
ODE_API int dJointGetCouplingAxis(dJointID coupling, int i);
ODE_API dReal dJointGetCouplingFactor(dJointID coupling, int i);

/** - dJointSetCouplingParam: Set a parameter of the coupling to value: dParamLoStop and dParamHiStop, m or rad, 0 at
      first; dParamStopERP, dParamStopCFM and dParamBounce. Equal stops hold s there; a stop of -dInfinity or
      dInfinity is none. Others have no effect. Refused: NaN, and
      dInfinity where it is no stop.
    - dJointGetCouplingParam: Returns a parameter, 0 if the coupling does not have it. [ours] */
ODE_API void dJointSetCouplingParam(dJointID coupling, int parameter, dReal value);
ODE_API dReal dJointGetCouplingParam(dJointID coupling, int parameter);

/** Returns the force along s that stops, springs and drives of the coupling have exerted, N or N m, the mean
    over the last step in which it acted; positive lets s grow. Axis i received its factor times this. [ours] */
ODE_API dReal dJointGetCouplingForce(dJointID coupling);

#ifdef __cplusplus
}
#endif

#endif
