// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint types one by one: anchors, axes, readings, parameters, forces. Included by objects.h, which has
// what all joints share (creation, attachment, feedback); programs include that one or ode.h.
//
// Body 1 and body 2 are those of dJointAttach, in its order. Each chapter names the rows that the joint
// always has and the axes that may carry a limit and a motor. Conventions of objects.h hold: world frame, SI
// units, radians.
#ifndef _ODE_OBJECTS_JOINTS_H_
#define _ODE_OBJECTS_JOINTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter ball Ball joints: 3 rows

    Holds a point of body 1 to a point of body 2. Parameters: dParamERP, dParamCFM.

    Anchors and axes are given where they are in the world at that moment and stick to the bodies from
    then on; on a joint without bodies such setters do nothing. Getters tell where the first body has them
    now; of a joint without bodies they write nothing and answer 0. Rates and angles count body 1 relative
    to body 2.

    Arguments:
    - joint: a joint of the type that the function is named for.
    - x, y, z: a point, m; or an axis, of any length but zero, normalised here. World frame.
    - result: where 3 reals are written, world frame.
    - parameter: a number dParam... of common.h; those that the type does not have are ignored, and read
      as 0.
    - value: the parameter's value, in its unit.

    Refused: a joint that is 0, destroyed or of another type; numbers that are not finite (stops and FMax
    may be infinite); a zero axis; a null result. Nothing changes then, and getters answer 0. */

/** The point that both bodies have in common. Default: the origin of each body. [0.16] */
ODE_API void dJointSetBallAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** Sets only body 2's anchor; (x, y, z) is in body 2's frame (in the world's when there is no body 2).
    [0.16] */
ODE_API void dJointSetBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** The anchor as body 1 (body 2) has it now; they differ by the joint's error. [guide] */
ODE_API void dJointGetBallAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetBallAnchor2(dJointID joint, dVector3 result);

/** A parameter of the joint: dParamERP or dParamCFM, at first those of the world. [0.16] */
ODE_API void dJointSetBallParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetBallParam(dJointID joint, int parameter);

/** @chapter hinge Hinge joints: 5 rows, limit and motor

    A common point and a common axis. Default axis x. Parameters: the plain names. Refused: as for ball
    joints. */

/** The point that both bodies have in common. The angle then reads 0. [guide] */
ODE_API void dJointSetHingeAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetHingeAnchor, with body 2's anchor moved by (ax, ay, az), m, when body 2 is the world.
    [0.16] */
ODE_API void dJointSetHingeAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                       dReal az);

/** The axis that both bodies have in common. The angle then reads 0. [guide] */
ODE_API void dJointSetHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis and shifts the zero so that the angle now reads -angle (rad). [0.16] */
ODE_API void dJointSetHingeAxisOffset(dJointID joint, dReal x, dReal y, dReal z, dReal angle);

/** A parameter of the hinge's limit and motor. [guide] */
ODE_API void dJointSetHingeParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetHingeParam(dJointID joint, int parameter);

/** Apply a torque (N m) about the axis to body 1 and the opposite to body 2, for the next step. [0.16] */
ODE_API void dJointAddHingeTorque(dJointID joint, dReal torque);

/** The anchor as body 1 (body 2) has it now; they differ by the joint's error. [guide] */
ODE_API void dJointGetHingeAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHingeAnchor2(dJointID joint, dVector3 result);

/** The axis as body 1 has it now, a unit vector. [guide] */
ODE_API void dJointGetHingeAxis(dJointID joint, dVector3 result);

/** Rotation of body 1 relative to body 2 about the axis since the anchor or axis was set, within [-pi,
    pi], rad; and its rate, rad/s. Both change sign when attached as (0, body). [guide] */
ODE_API dReal dJointGetHingeAngle(dJointID joint);
ODE_API dReal dJointGetHingeAngleRate(dJointID joint);

/** @chapter slider Slider joints: 5 rows, limit and motor

    No relative rotation, translation along one axis only. Default axis x. It has no anchor. Parameters:
    the plain names. Refused: as for ball joints. */

/** The axis of the sliding. The position then reads 0, and the present rotation is the one to keep.
    [guide] */
ODE_API void dJointSetSliderAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis, with the zero position shifted by (ax, ay, az), m, when body 2 is the world: the
    position then reads -(axis . a). [0.16] */
ODE_API void dJointSetSliderAxisDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                      dReal az);

/** A parameter of the slider's limit and motor. [guide] */
ODE_API void dJointSetSliderParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetSliderParam(dJointID joint, int parameter);

/** Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step; the torque
    that keeps angular momentum is added, too. [0.16] */
ODE_API void dJointAddSliderForce(dJointID joint, dReal force);

/** How far body 1 has moved along the axis since the axis was set, m; and its rate, m/s. Both change sign
    when attached as (0, body). [guide] */
ODE_API dReal dJointGetSliderPosition(dJointID joint);
ODE_API dReal dJointGetSliderPositionRate(dJointID joint);

/** The axis as body 1 has it now, a unit vector. [guide] */
ODE_API void dJointGetSliderAxis(dJointID joint, dVector3 result);

/** @chapter universal Universal joints: 4 rows, 2 limits and motors

    A common point, and axis 1 (of body 1) kept perpendicular to axis 2 (of body 2): a cardan joint.
    Defaults x and y. Parameters: axis 1, and axis 2 with the names ending in 2. Refused: as for ball
    joints. */

/** The point that both bodies have in common. The angles then read 0. [guide] */
ODE_API void dJointSetUniversalAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** The axis of body 1 (body 2); set them perpendicular. The angles then read 0. [guide] */
ODE_API void dJointSetUniversalAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis2(dJointID joint, dReal x, dReal y, dReal z);

/** Set an axis and shift the zeros so that the angles now read offset1 and offset2, rad. [0.16] */
ODE_API void dJointSetUniversalAxis1Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);
ODE_API void dJointSetUniversalAxis2Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);

/** A parameter of one of the two limits and motors. [0.16] */
ODE_API void dJointSetUniversalParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetUniversalParam(dJointID joint, int parameter);

/** Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddUniversalTorques(dJointID joint, dReal torque1, dReal torque2);

/** The anchor as body 1 (body 2) has it now; they differ by the joint's error. [guide] */
ODE_API void dJointGetUniversalAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAnchor2(dJointID joint, dVector3 result);

/** Axis 1 as body 1 has it now, axis 2 as body 2 has it, unit vectors. [guide] */
ODE_API void dJointGetUniversalAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAxis2(dJointID joint, dVector3 result);

/** Angles between each body and the cross piece about its axis, rad, within [-pi, pi]. The first form
    writes both to *angle1 and *angle2, of which neither may be null. [0.16] */
ODE_API void dJointGetUniversalAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetUniversalAngle1(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2(dJointID joint);

/** Rates of the two angles, rad/s. [0.16] */
ODE_API dReal dJointGetUniversalAngle1Rate(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2Rate(dJointID joint);

/** @chapter hinge2 Hinge-2 joints: 4 rows, 2 limits and motors

    A car wheel: body 1 is the chassis with axis 1 (steering, also the direction of the suspension), body
    2 the wheel with axis 2 (spin). The angle between the axes is kept as set. Both bodies are needed.
    Parameters: axis 1; axis 2 with names ending in 2 (motor only, its stops are not used);
    dParamSuspensionERP and dParamSuspensionCFM for the play along axis 1. Refused: as for ball joints,
    and attaching to one body only. */

/** The centre of the wheel, common to both bodies. The angles then read 0. [guide] */
ODE_API void dJointSetHinge2Anchor(dJointID joint, dReal x, dReal y, dReal z);

/** Set axis1 and axis2, each 3 reals, world frame, of any length but zero; NULL keeps one (not both). Two
    parallel axes are refused; one alone may be parallel to the other until that is set too (while they are,
    one turn is left free). The angles then read 0. [0.16] */
ODE_API void dJointSetHinge2Axes(dJointID joint, const dReal* axis1, const dReal* axis2);

/** Old forms that set one axis. [guide] */
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis2(dJointID joint, dReal x, dReal y, dReal z);

/** A parameter of one of the two axes, or of the suspension. [guide] */
ODE_API void dJointSetHinge2Param(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetHinge2Param(dJointID joint, int parameter);

/** Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddHinge2Torques(dJointID joint, dReal torque1, dReal torque2);

/** The anchor as body 1 (body 2) has it now; they differ by the travel of the suspension. [guide] */
ODE_API void dJointGetHinge2Anchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Anchor2(dJointID joint, dVector3 result);

/** Axis 1 as body 1 has it now, axis 2 as body 2 has it, unit vectors. [guide] */
ODE_API void dJointGetHinge2Axis1(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Axis2(dJointID joint, dVector3 result);

/** Steering angle of body 1 relative to body 2 about axis 1, within (-pi, pi], rad. [guide] */
ODE_API dReal dJointGetHinge2Angle1(dJointID joint);

/** Spin angle about axis 2, within (-pi, pi], rad: it grows as the wheel turns forward about axis 2.
    [0.16] */
ODE_API dReal dJointGetHinge2Angle2(dJointID joint);

/** Rates of body 1 relative to body 2 about the axes, rad/s. Note that Angle2Rate therefore has the
    opposite sign of the change of Angle2. [guide] */
ODE_API dReal dJointGetHinge2Angle1Rate(dJointID joint);
ODE_API dReal dJointGetHinge2Angle2Rate(dJointID joint);

/** @chapter fixed Fixed joints: 6 rows

    Holds the relative pose. Two bodies that never part are better one body. Parameters: dParamERP and
    dParamCFM, of the linear rows. Refused: as for ball joints. */

/** Take the current relative pose as the one to keep. Call it after attaching: attaching alone does not.
    [0.16] */
ODE_API void dJointSetFixed(dJointID joint);

/** A parameter of the joint: dParamERP or dParamCFM, at first those of the world. [0.16] */
ODE_API void dJointSetFixedParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetFixedParam(dJointID joint, int parameter);

/** @chapter amotor Angular motors: up to 3 rows

    Motors and stops on relative rotation about up to three axes; no other constraint. Often used on top
    of a ball joint. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3.
    Arguments:
    - anum: number of the axis, 0, 1 or 2.
    - rel: what an axis moves with: 0 the world, 1 body 1, 2 body 2.

    Refused: as for ball joints; an anum or rel that there is not. */

/** What mode the motor is in. dAMotorUser (default): the program sets axes and, for stops, angles.
    dAMotorEuler: three axes, of which the program sets axis 0 (fixed in body 1) and axis 2 (fixed in body
    2), perpendicular at that time; axis 1 and the Euler angles follow. The angle about axis 1 must stay
    within (-pi/2, pi/2): give it stops. Another mode is refused. [guide] */
ODE_API void dJointSetAMotorMode(dJointID joint, int mode);
ODE_API int dJointGetAMotorMode(dJointID joint);

/** How many axes are in use: num is 0 ... 3 (others are refused), default 0; in Euler mode it is always
    3. [guide] */
ODE_API void dJointSetAMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetAMotorNumAxes(dJointID joint);

/** Axis anum and what it moves with: rel 0 the world, 1 body 1, 2 body 2. (x, y, z) is in the world frame
    in any case, and so is result. In Euler mode axis 0 goes with body 1 and axis 2 with body 2, else the
    call is refused. [guide] */
ODE_API void dJointSetAMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);
ODE_API void dJointGetAMotorAxis(dJointID joint, int anum, dVector3 result);
ODE_API int dJointGetAMotorAxisRel(dJointID joint, int anum);

/** The angle about axis anum that stops are compared with, rad. User mode: what the program says, before
    each step, default 0; setting is refused in Euler mode, where the last step's Euler angles are given.
    [guide] */
ODE_API void dJointSetAMotorAngle(dJointID joint, int anum, dReal angle);
ODE_API dReal dJointGetAMotorAngle(dJointID joint, int anum);

/** Relative angular velocity of the bodies about axis anum, rad/s. [0.16] */
ODE_API dReal dJointGetAMotorAngleRate(dJointID joint, int anum);

/** A parameter of one of the three limits and motors. [guide] */
ODE_API void dJointSetAMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetAMotorParam(dJointID joint, int parameter);

/** Apply torque1, torque2, torque3 (N m) about the axes in use to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddAMotorTorques(dJointID joint, dReal torque1, dReal torque2, dReal torque3);

/** @chapter lmotor Linear motors: up to 3 rows

    Motors on the relative velocity of the bodies' centres along up to three axes; no other constraint. It
    has no stops. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3. Refused: as for ball
    joints. */

/** How many axes are in use: num, held to 0 ... 3, default 0. [0.16] */
ODE_API void dJointSetLMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetLMotorNumAxes(dJointID joint);

/** Axis anum (0, 1, 2) and what it turns with: rel 0 the world, 1 body 1, 2 body 2 (body 1 when there is
    no body 2). (x, y, z) is in the world frame in any case. [0.16] */
ODE_API void dJointSetLMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);

/** Axis anum as it is stored: result is in the frame of the body it turns with, or in the world's. [0.16] */
ODE_API void dJointGetLMotorAxis(dJointID joint, int anum, dVector3 result);

/** A parameter of one of the three motors. [0.16] */
ODE_API void dJointSetLMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetLMotorParam(dJointID joint, int parameter);

/** @chapter plane2d Plane joints: 3 rows, 3 motors

    Keeps body 1 in the world's plane z = 0, turning about z only; attach it as (body, 0). It removes
    rates of tilt, not a tilt that is there: put the body upright first, and set its orientation back now
    and then. Refused: as for ball joints. */

/** A parameter of the motor along x, along y, about z: the plain names. There are no stops. [0.16] */
ODE_API void dJointSetPlane2DXParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DYParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DAngleParam(dJointID joint, int parameter, dReal value);

/** @chapter pr Prismatic-rotoid joints: 4 rows, 2 limits and motors

    Body 2 turns about axis 2 through the anchor; the anchor slides along axis 1 of body 1. Set the axes
    perpendicular. Defaults: axis 1 (slide) y, axis 2 (turn) x. Parameters: the slide; the turn with names
    ending in 2. Attached as (0, body), positions, angles and their rates change sign. Refused: as for
    ball joints. */

/** The point on the turning axis. The position reads 0 afterwards; the angle keeps its zero. [0.16] */
ODE_API void dJointSetPRAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** The axis of the slide (1) and of the turn (2). Both set the zero of the angle, too. [0.16] */
ODE_API void dJointSetPRAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPRAxis2(dJointID joint, dReal x, dReal y, dReal z);

/** A parameter of the slide's or the turn's limit and motor. [0.16] */
ODE_API void dJointSetPRParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPRParam(dJointID joint, int parameter);

/** Apply a torque (N m) about axis 2 to body 1 and the opposite to body 2, for the next step. [0.16] */
ODE_API void dJointAddPRTorque(dJointID joint, dReal torque);

/** The anchor as body 2 has it now. [0.16] */
ODE_API void dJointGetPRAnchor(dJointID joint, dVector3 result);

/** The axes as body 1 has them now, unit vectors. [0.16] */
ODE_API void dJointGetPRAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPRAxis2(dJointID joint, dVector3 result);

/** How far body 1's anchor is along axis 1 from body 2's, m; and how fast that changes, m/s. [0.16] */
ODE_API dReal dJointGetPRPosition(dJointID joint);
ODE_API dReal dJointGetPRPositionRate(dJointID joint);

/** Rotation of body 1 relative to body 2 about axis 2, within [-pi, pi], rad; and its rate, rad/s. [0.16] */
ODE_API dReal dJointGetPRAngle(dJointID joint);
ODE_API dReal dJointGetPRAngleRate(dJointID joint);

/** @chapter pu Prismatic-universal joints: 3 rows, 3 limits and motors

    A universal joint (axis 1 of body 1, axis 2 of body 2, kept perpendicular) whose anchor slides along a
    third axis of body 1. Defaults: axis 1 y, axis 2 z, axis 3 x. Parameters: axis 1; axis 2 and the slide
    (axis 3) with names ending in 2 and 3. Attached as (0, body), axes 1 and 2 and their angles change
    places, and the position changes sign. Refused: as for ball joints. */

/** The point where axes 1 and 2 meet. The position and the angles read 0 afterwards. [0.16] */
ODE_API void dJointSetPUAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetPUAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position reads
    axis 3 . (dx, dy, dz). [0.16] */
ODE_API void dJointSetPUAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz);

/** Old form: the position reads -axis 3 . (dx, dy, dz), m, or plus when attached as (0, body). [0.16] */
ODE_API_DEPRECATED ODE_API void dJointSetPUAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal dx,
                                                       dReal dy, dReal dz);

/** The axes of the universal joint (1 and 2) and of the slide (3; P is another name of it). The first two
    set the zeros of the angles, too. [0.16] */
ODE_API void dJointSetPUAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis3(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxisP(dJointID joint, dReal x, dReal y, dReal z);

/** A parameter of one of the three limits and motors. [0.16] */
ODE_API void dJointSetPUParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPUParam(dJointID joint, int parameter);

/** The anchor as body 2 has it now. [0.16] */
ODE_API void dJointGetPUAnchor(dJointID joint, dVector3 result);

/** The axes as their bodies have them now, unit vectors. [0.16] */
ODE_API void dJointGetPUAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis2(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis3(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxisP(dJointID joint, dVector3 result);

/** How far body 1's anchor is along axis 3 from body 2's, m; and how fast that changes, m/s. [0.16] */
ODE_API dReal dJointGetPUPosition(dJointID joint);
ODE_API dReal dJointGetPUPositionRate(dJointID joint);

/** Angles about axis 1 and axis 2, rad, and their rates, rad/s, as of the universal joint. The first form
    writes both angles to *angle1 and *angle2, of which neither may be null. [0.16] */
ODE_API void dJointGetPUAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetPUAngle1(dJointID joint);
ODE_API dReal dJointGetPUAngle1Rate(dJointID joint);
ODE_API dReal dJointGetPUAngle2(dJointID joint);
ODE_API dReal dJointGetPUAngle2Rate(dJointID joint);

/** @chapter piston Pistons: 4 rows, 2 limits and motors

    Body 1 slides along one axis and turns about it. Default axis x. Parameters: the slide; the turn with
    names ending in 2. Attached as (0, body), positions, angles and their rates change sign. Refused: as
    for ball joints. */

/** A point on the axis. The position and the angle read 0 afterwards. [0.16] */
ODE_API void dJointSetPistonAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetPistonAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position
    reads axis . (dx, dy, dz). [0.16] */
ODE_API void dJointSetPistonAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy,
                                         dReal dz);

/** The axis of the slide and the turn. Sets the zero of the angle, too. [0.16] */
ODE_API void dJointSetPistonAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Old form of little use: sets the axis, and the vector from body 1 to its anchor to the position of
    body 1 relative to body 2 (to the world) minus (ax, ay, az). Use dJointSetPistonAnchorOffset. [0.16] */
ODE_API_DEPRECATED ODE_API void dJointSetPistonAxisDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax,
                                                         dReal ay, dReal az);

/** A parameter of the slide's or the turn's limit and motor. [0.16] */
ODE_API void dJointSetPistonParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPistonParam(dJointID joint, int parameter);

/** Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step: on each of
    two bodies at its anchor, on one body at its centre. [0.16] */
ODE_API void dJointAddPistonForce(dJointID joint, dReal force);

/** The anchor as body 1 (body 2) has it now. [0.16] */
ODE_API void dJointGetPistonAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetPistonAnchor2(dJointID joint, dVector3 result);

/** The axis as body 1 has it now, a unit vector. [0.16] */
ODE_API void dJointGetPistonAxis(dJointID joint, dVector3 result);

/** How far body 1's anchor is along the axis from body 2's, m; and the velocity along the axis of body
    1's centre relative to body 2's, m/s. [0.16] */
ODE_API dReal dJointGetPistonPosition(dJointID joint);
ODE_API dReal dJointGetPistonPositionRate(dJointID joint);

/** Rotation of body 1 relative to body 2 about the axis, within [-pi, pi], rad; and its rate, rad/s.
    [0.16] */
ODE_API dReal dJointGetPistonAngle(dJointID joint);
ODE_API dReal dJointGetPistonAngleRate(dJointID joint);

/** @chapter dball Double ball joints: 1 row

    Keeps the distance between a point of body 1 and a point of body 2: a rod with a ball joint at each
    end, which pulls and pushes. Parameters: dParamERP, dParamCFM. Refused: as for ball joints. */

/** Each sets the point of one body and takes the present distance as the one to keep, as attaching does.
    [0.16] */
ODE_API void dJointSetDBallAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** The distance to keep, m; a negative one is refused. The getter gives this, not the present one. [0.16] */
ODE_API void dJointSetDBallDistance(dJointID joint, dReal distance);
ODE_API dReal dJointGetDBallDistance(dJointID joint);

/** A parameter of the joint: dParamERP or dParamCFM, at first those of the world. [0.16] */
ODE_API void dJointSetDBallParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetDBallParam(dJointID joint, int parameter);

/** Where the points of body 1 and of body 2 are now. [0.16] */
ODE_API void dJointGetDBallAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetDBallAnchor2(dJointID joint, dVector3 result);

/** @chapter dhinge Double hinge joints: 4 rows

    A bar with a hinge at each end, the hinges being parallel: keeps an axis common to both bodies, the
    distance between a point of each, and their offset along the axis. Parameters: dParamERP, dParamCFM
    (of the distance). Refused: as for ball joints. */

/** The common axis. Needs a body; before it is called the joint keeps no axis. [0.16] */
ODE_API void dJointSetDHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Each sets the point of one body and takes the present distance as the one to keep, as attaching does.
    [0.16] */
ODE_API void dJointSetDHingeAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDHingeAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** A parameter of the joint: dParamERP or dParamCFM, at first those of the world. [0.16] */
ODE_API void dJointSetDHingeParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetDHingeParam(dJointID joint, int parameter);

/** Where the axis, as body 1 has it, and the points of body 1 and of body 2 are now. [0.16] */
ODE_API void dJointGetDHingeAxis(dJointID joint, dVector3 result);
ODE_API void dJointGetDHingeAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetDHingeAnchor2(dJointID joint, dVector3 result);

/** The distance to keep, m. [0.16] */
ODE_API dReal dJointGetDHingeDistance(dJointID joint);

/** @chapter transmission Transmissions: 1 row

    Two wheels whose rims do not slip: gears, bevel gears, or wheels with a chain around them, by mode
    (common.h). Wheel i turns with body i about axis i through anchor i; hinges to hold it there are the
    program's business. Both bodies are needed. Parameters: dParamERP, dParamCFM.
    dTransmissionParallelAxes (default): gears in contact between the anchors, turning in opposite senses.
    Give one axis and the ratio of the radii. dTransmissionIntersectingAxes: bevel gears. Give two axes;
    each wheel lies in the plane across its axis through its anchor, and contact is where the planes meet.
    Radii and ratio follow. dTransmissionChainDrive: a chain around both wheels, which turn in one sense.
    Give one axis and the radii. A step after axes, anchors, mode or bodies have been set starts the
    angles at zero; after ratio or radii have been set, what slip there is becomes zero. Should axes point
    against each other, axis 1 is turned round then.

    Refused: as for ball joints; attaching to one body only; what belongs to another mode than the
    joint's. */

/** What kind of wheels: mode is one of the three numbers dTransmission...; another one is refused. [0.16] */
ODE_API void dJointSetTransmissionMode(dJointID joint, int mode);
ODE_API int dJointGetTransmissionMode(dJointID joint);

/** Centres of the wheels; at first the centres of the bodies. [0.16] */
ODE_API void dJointSetTransmissionAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAnchor2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAnchor2(dJointID joint, dVector3 result);

/** The axis of both wheels; refused with intersecting axes. Default: x of each body. [0.16] */
ODE_API void dJointSetTransmissionAxis(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis(dJointID joint, dVector3 result);

/** The axis of one wheel; to be set with intersecting axes only. [0.16] */
ODE_API void dJointSetTransmissionAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAxis2(dJointID joint, dVector3 result);

/** The ratio radius 1 / radius 2, positive; to be set with parallel axes only. Default 1. [0.16] */
ODE_API void dJointSetTransmissionRatio(dJointID joint, dReal ratio);
ODE_API dReal dJointGetTransmissionRatio(dJointID joint);

/** The radius of each wheel, m, positive; to be set for a chain only, else as measured by the first step.
    Without radii a chain does nothing. [0.16] */
ODE_API void dJointSetTransmissionRadius1(dJointID joint, dReal radius);
ODE_API void dJointSetTransmissionRadius2(dJointID joint, dReal radius);
ODE_API dReal dJointGetTransmissionRadius1(dJointID joint);
ODE_API dReal dJointGetTransmissionRadius2(dJointID joint);

/** The backlash: free play of the rims to either side of zero slip, m, default 0; a negative one is
    refused. [0.16] */
ODE_API void dJointSetTransmissionBacklash(dJointID joint, dReal backlash);
ODE_API dReal dJointGetTransmissionBacklash(dJointID joint);

/** A parameter of the joint: dParamERP or dParamCFM, at first those of the world. [0.16] */
ODE_API void dJointSetTransmissionParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetTransmissionParam(dJointID joint, int parameter);

/** What the last step began with: how far the point of contact has run around each wheel, as its body
    sees it, about its axis, rad (a wheel that turns forward counts backward; full turns add up); and
    where the wheels, or wheel and chain, touched. [0.16] */
ODE_API dReal dJointGetTransmissionAngle1(dJointID joint);
ODE_API dReal dJointGetTransmissionAngle2(dJointID joint);
ODE_API void dJointGetTransmissionContactPoint1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionContactPoint2(dJointID joint, dVector3 result);

#ifdef __cplusplus
}
#endif

#endif
