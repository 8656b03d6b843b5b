/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The joint types one by one: anchors, axes, readings, parameters, forces. Included by objects.h, which has
 * what all joints share (creation, attachment, feedback); programs include that one or ode.h.
 *
 * Body 1 and body 2 are those of dJointAttach, in its order. Each chapter names the rows that the joint
 * always has and the axes that may carry a limit and a motor. Conventions of objects.h hold: world frame, SI
 * units, radians. It is long, as objects.h is, because every entry documents itself. */
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
      as 0. docs/guide/joint_parameters.md has each one's meaning, unit and default, and who takes it.
    - value: the parameter's value, in its unit.

    Refused: a joint that is 0, destroyed or of another type; [!dJointSet*Param] numbers that are not
    finite; [dJointSet*Param] NaN; [dJointSet*Param] infinity for what is neither a stop nor FMax;
    [dJointSet*Axis, dJointSetHinge2Axes] a zero axis; null pointers. Nothing changes then, and getters answer
    0. */

/** The point that both bodies have in common. Default: the origin of each body. [0.16] */
ODE_API void dJointSetBallAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** Sets only body 2's anchor; (x, y, z) is in body 2's frame (in the world's when there is no body 2).
    [0.16] */
ODE_API void dJointSetBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointGetBallAnchor: Write the anchor as body 1 has it now to result, m, world frame. It differs from
      dJointGetBallAnchor2 by the joint's error.
    - dJointGetBallAnchor2: Write the anchor as body 2 has it now to result, m, world frame. It differs from
      dJointGetBallAnchor by the joint's error. [guide] */
ODE_API void dJointGetBallAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetBallAnchor2(dJointID joint, dVector3 result);

/** - dJointSetBallParam: Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
      the world.
    - dJointGetBallParam: The value of a parameter of the joint: dParamERP or dParamCFM. [0.16] */
ODE_API void dJointSetBallParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetBallParam(dJointID joint, int parameter);

/** @chapter hinge Hinge joints: 5 rows, limit and motor

    A common point and a common axis. Default axis x. Parameters: the plain names. Refused: as for ball. */

/** The point that both bodies have in common. The angle then reads 0. [guide] */
ODE_API void dJointSetHingeAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetHingeAnchor, with body 2's anchor moved by (ax, ay, az), m, when body 2 is the world.
    [0.16] */
ODE_API void dJointSetHingeAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                       dReal az);

/** The axis that both bodies have in common. The angle then reads 0. [guide] */
ODE_API void dJointSetHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis and shifts the zero of the angle, rad. With t the turn about the axis from body 2's
    orientation to body 1's, the angle then reads 2 t - angle: t if the bodies are turned by the given angle,
    -angle if they are not turned; attached as (0, B), all of it counts the turn the other way round. [0.16] */
ODE_API void dJointSetHingeAxisOffset(dJointID joint, dReal x, dReal y, dReal z, dReal angle);

/** - dJointSetHingeParam: Set a parameter of the hinge's limit and motor to value; its unit is in the table
      of parameters.
    - dJointGetHingeParam: The value of a parameter of the hinge's limit and motor. [guide] */
ODE_API void dJointSetHingeParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetHingeParam(dJointID joint, int parameter);

/** Apply a torque (N m) about the axis to body 1 and the opposite to body 2, for the next step. [0.16] */
ODE_API void dJointAddHingeTorque(dJointID joint, dReal torque);

/** - dJointGetHingeAnchor: Write the anchor as body 1 has it now to result, m, world frame. It differs from
      dJointGetHingeAnchor2 by the joint's error.
    - dJointGetHingeAnchor2: Write the anchor as body 2 has it now to result, m, world frame. It differs from
      dJointGetHingeAnchor by the joint's error. [guide] */
ODE_API void dJointGetHingeAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHingeAnchor2(dJointID joint, dVector3 result);

/** The axis as body 1 has it now, a unit vector. [guide] */
ODE_API void dJointGetHingeAxis(dJointID joint, dVector3 result);

/** It changes sign when the joint is attached as (0, body).
    - dJointGetHingeAngle: The rotation of body 1 relative to body 2 about the axis since the anchor or axis
      was set, rad, within [-pi, pi].
    - dJointGetHingeAngleRate: The rate of the hinge's angle, rad/s. [guide] */
ODE_API dReal dJointGetHingeAngle(dJointID joint);
ODE_API dReal dJointGetHingeAngleRate(dJointID joint);

/** @chapter slider Slider joints: 5 rows, limit and motor

    No relative rotation, translation along one axis only. Default axis x. It has no anchor. Parameters:
    the plain names. Refused: as for ball. */

/** The axis of the sliding. The position then reads 0, and the present rotation is the one to keep.
    [guide] */
ODE_API void dJointSetSliderAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis, with the zero position shifted by (ax, ay, az), m, when body 2 is the world: the
    position then reads -(axis . a). [0.16] */
ODE_API void dJointSetSliderAxisDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                      dReal az);

/** - dJointSetSliderParam: Set a parameter of the slider's limit and motor to value; its unit is in the
      table of parameters.
    - dJointGetSliderParam: The value of a parameter of the slider's limit and motor. [guide] */
ODE_API void dJointSetSliderParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetSliderParam(dJointID joint, int parameter);

/** Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step; the torque
    that keeps angular momentum is added, too. [0.16] */
ODE_API void dJointAddSliderForce(dJointID joint, dReal force);

/** It changes sign when the joint is attached as (0, body).
    - dJointGetSliderPosition: How far body 1 has moved along the axis, relative to body 2, since the axis
      was set, m.
    - dJointGetSliderPositionRate: The rate of the slider's position, m/s. [guide] */
ODE_API dReal dJointGetSliderPosition(dJointID joint);
ODE_API dReal dJointGetSliderPositionRate(dJointID joint);

/** The axis as body 1 has it now, a unit vector. [guide] */
ODE_API void dJointGetSliderAxis(dJointID joint, dVector3 result);

/** @chapter universal Universal joints: 4 rows, 2 limits and motors

    A common point, and axis 1 (of body 1) kept perpendicular to axis 2 (of body 2): a cardan joint.
    Defaults x and y. Parameters: axis 1, and axis 2 with the names ending in 2. Refused: as for ball. */

/** The point that both bodies have in common. The angles then read 0. [guide] */
ODE_API void dJointSetUniversalAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** The angles then read 0.
    - dJointSetUniversalAxis1: Set axis 1, which moves with body 1; set it perpendicular to axis 2.
    - dJointSetUniversalAxis2: Set axis 2, which moves with body 2; set it perpendicular to axis 1. [guide] */
ODE_API void dJointSetUniversalAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis2(dJointID joint, dReal x, dReal y, dReal z);

/** The zeros are shifted so that the angles now read offset1 and offset2, rad.
    - dJointSetUniversalAxis1Offset: Set axis 1, which moves with body 1, and the angles.
    - dJointSetUniversalAxis2Offset: Set axis 2, which moves with body 2, and the angles. [0.16] */
ODE_API void dJointSetUniversalAxis1Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);
ODE_API void dJointSetUniversalAxis2Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);

/** - dJointSetUniversalParam: Set a parameter of one of the two limits and motors to value: of axis 1 by the
      plain names, of axis 2 by those that end in 2.
    - dJointGetUniversalParam: The value of a parameter of one of the two limits and motors: of axis 1 by the
      plain names, of axis 2 by those that end in 2. [0.16] */
ODE_API void dJointSetUniversalParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetUniversalParam(dJointID joint, int parameter);

/** Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddUniversalTorques(dJointID joint, dReal torque1, dReal torque2);

/** - dJointGetUniversalAnchor: Write the anchor as body 1 has it now to result, m, world frame. It differs
      from dJointGetUniversalAnchor2 by the joint's error.
    - dJointGetUniversalAnchor2: Write the anchor as body 2 has it now to result, m, world frame. It differs
      from dJointGetUniversalAnchor by the joint's error. [guide] */
ODE_API void dJointGetUniversalAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAnchor2(dJointID joint, dVector3 result);

/** - dJointGetUniversalAxis1: Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    - dJointGetUniversalAxis2: Write axis 2 as body 2 has it now to result: a unit vector, world frame.
      [guide] */
ODE_API void dJointGetUniversalAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAxis2(dJointID joint, dVector3 result);

/** - dJointGetUniversalAngles: Write the angles between body 1 and the cross piece about axis 1, and between
      body 2 and the cross piece about axis 2, to *angle1 and *angle2: rad, within [-pi, pi]. Neither pointer
      may be null.
    - dJointGetUniversalAngle1: The angle between body 1 and the cross piece about axis 1, rad, within [-pi,
      pi].
    - dJointGetUniversalAngle2: The angle between body 2 and the cross piece about axis 2, rad, within [-pi,
      pi]. [0.16] */
ODE_API void dJointGetUniversalAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetUniversalAngle1(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2(dJointID joint);

/** - dJointGetUniversalAngle1Rate: The rate of the angle about axis 1, rad/s.
    - dJointGetUniversalAngle2Rate: The rate of the angle about axis 2, rad/s. [0.16] */
ODE_API dReal dJointGetUniversalAngle1Rate(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2Rate(dJointID joint);

/** @chapter hinge2 Hinge-2 joints: 4 rows, 2 limits and motors

    A car wheel: body 1 is the chassis with axis 1 (steering, also the direction of the suspension), body
    2 the wheel with axis 2 (spin). The angle between the axes is kept as set. Both bodies are needed.
    Parameters: axis 1; axis 2 with names ending in 2 (motor only, its stops are not used);
    dParamSuspensionERP and dParamSuspensionCFM for the play along axis 1.

    Attaching to one body only is refused.

    Refused: as for ball. */

/** The centre of the wheel, common to both bodies. The angles then read 0. [guide] */
ODE_API void dJointSetHinge2Anchor(dJointID joint, dReal x, dReal y, dReal z);

/** Set axis1 and axis2, each 3 reals, world frame, of any length but zero; NULL keeps one (not both). Two
    parallel axes are refused; one alone may be parallel to the other until that is set too (while they are,
    one turn is left free). The angles then read 0. [0.16] */
ODE_API void dJointSetHinge2Axes(dJointID joint, const dReal* axis1, const dReal* axis2);

/** The other axis stays. dJointSetHinge2Axes sets both.
    - dJointSetHinge2Axis1: Old form: set axis 1, of the steering, which moves with body 1.
    - dJointSetHinge2Axis2: Old form: set axis 2, of the spin, which moves with body 2. [guide] */
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis2(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointSetHinge2Param: Set a parameter to value: of axis 1 by the plain names, of the motor of axis 2 by
      those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM.
    - dJointGetHinge2Param: The value of a parameter: of axis 1 by the plain names, of the motor of axis 2 by
      those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM. [guide] */
ODE_API void dJointSetHinge2Param(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetHinge2Param(dJointID joint, int parameter);

/** Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddHinge2Torques(dJointID joint, dReal torque1, dReal torque2);

/** - dJointGetHinge2Anchor: Write the anchor as body 1 has it now to result, m, world frame. It differs from
      dJointGetHinge2Anchor2 by the travel of the suspension.
    - dJointGetHinge2Anchor2: Write the anchor as body 2 has it now to result, m, world frame. It differs
      from dJointGetHinge2Anchor by the travel of the suspension. [guide] */
ODE_API void dJointGetHinge2Anchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Anchor2(dJointID joint, dVector3 result);

/** - dJointGetHinge2Axis1: Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    - dJointGetHinge2Axis2: Write axis 2 as body 2 has it now to result: a unit vector, world frame. [guide]
 */
ODE_API void dJointGetHinge2Axis1(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Axis2(dJointID joint, dVector3 result);

/** Steering angle of body 1 relative to body 2 about axis 1, within (-pi, pi], rad. [guide] */
ODE_API dReal dJointGetHinge2Angle1(dJointID joint);

/** Spin angle about axis 2, within (-pi, pi], rad: it grows as the wheel turns forward about axis 2.
    [0.16] */
ODE_API dReal dJointGetHinge2Angle2(dJointID joint);

/** - dJointGetHinge2Angle1Rate: The rate of the steering angle, of body 1 relative to body 2 about axis 1,
      rad/s.
    - dJointGetHinge2Angle2Rate: The angular velocity of body 1 relative to body 2 about axis 2, rad/s. It
      has the opposite sign of the change of dJointGetHinge2Angle2. [guide] */
ODE_API dReal dJointGetHinge2Angle1Rate(dJointID joint);
ODE_API dReal dJointGetHinge2Angle2Rate(dJointID joint);

/** @chapter fixed Fixed joints: 6 rows

    Holds the relative pose. Two bodies that never part are better one body. Parameters: dParamERP and
    dParamCFM, of the linear rows. Refused: as for ball. */

/** Take the current relative pose as the one to keep. Call it after attaching: attaching alone does not.
    [0.16] */
ODE_API void dJointSetFixed(dJointID joint);

/** - dJointSetFixedParam: Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
      the world.
    - dJointGetFixedParam: The value of a parameter of the joint: dParamERP or dParamCFM. [0.16] */
ODE_API void dJointSetFixedParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetFixedParam(dJointID joint, int parameter);

/** @chapter amotor Angular motors: up to 3 rows

    Motors and stops on relative rotation about up to three axes; no other constraint. Often used on top
    of a ball joint. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3.
    Arguments:
    - anum: number of the axis, 0, 1 or 2.
    - rel: what an axis moves with: 0 the world, 1 body 1, 2 body 2.

    Refused: as for ball; [dJointSetAMotorA, dJointGetAMotorA] an axis number that there is not;
    [dJointSetAMotorAxis] a rel that there is not. */

/** - dJointSetAMotorMode: Set what mode the motor is in. dAMotorUser (default): the program sets axes and,
      for stops, angles. dAMotorEuler: three axes, of which the program sets axis 0 (fixed in body 1) and
      axis 2 (fixed in body 2), perpendicular at that time; axis 1 and the Euler angles follow. The angle
      about axis 1 must stay within (-pi/2, pi/2): give it stops. Another mode is refused.
    - dJointGetAMotorMode: The motor's mode: dAMotorUser or dAMotorEuler. [guide] */
ODE_API void dJointSetAMotorMode(dJointID joint, int mode);
ODE_API int dJointGetAMotorMode(dJointID joint);

/** - dJointSetAMotorNumAxes: Set how many axes are in use: num is 0 ... 3 (others are refused), default 0;
      in Euler mode it is always 3.
    - dJointGetAMotorNumAxes: How many axes are in use. [guide] */
ODE_API void dJointSetAMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetAMotorNumAxes(dJointID joint);

/** - dJointSetAMotorAxis: Set axis anum to (x, y, z), world frame, and what it moves with: rel 0 the world,
      1 body 1, 2 body 2. In Euler mode axis 0 goes with body 1 and axis 2 with body 2: with rel 0 their
      (x, y, z) are in the frame of that body, and the other body is refused.
    - dJointGetAMotorAxis: Write axis anum as it is now to result: a unit vector, world frame.
    - dJointGetAMotorAxisRel: What axis anum moves with: 0 the world, 1 body 1, 2 body 2. [guide] */
ODE_API void dJointSetAMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);
ODE_API void dJointGetAMotorAxis(dJointID joint, int anum, dVector3 result);
ODE_API int dJointGetAMotorAxisRel(dJointID joint, int anum);

/** - dJointSetAMotorAngle: Tell the motor the angle about axis anum, rad, with which stops are compared;
      default 0. A program in user mode does so before each step; in Euler mode the call is refused.
    - dJointGetAMotorAngle: The angle about axis anum, rad: in user mode what the program has set, in Euler
      mode that of the last step. [guide] */
ODE_API void dJointSetAMotorAngle(dJointID joint, int anum, dReal angle);
ODE_API dReal dJointGetAMotorAngle(dJointID joint, int anum);

/** Relative angular velocity of the bodies about axis anum, rad/s. [0.16] */
ODE_API dReal dJointGetAMotorAngleRate(dJointID joint, int anum);

/** - dJointSetAMotorParam: Set a parameter of one of the three limits and motors to value: of axis 0 by the
      plain names, of axis 1 and 2 by those that end in 2 and 3.
    - dJointGetAMotorParam: The value of a parameter of one of the three limits and motors: of axis 0 by the
      plain names, of axis 1 and 2 by those that end in 2 and 3. [guide] */
ODE_API void dJointSetAMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetAMotorParam(dJointID joint, int parameter);

/** Apply torque1, torque2, torque3 (N m) about the axes in use to body 1 and the opposite to body 2, for
    the next step. [0.16] */
ODE_API void dJointAddAMotorTorques(dJointID joint, dReal torque1, dReal torque2, dReal torque3);

/** @chapter lmotor Linear motors: up to 3 rows

    Motors on the relative velocity of the bodies' centres along up to three axes; no other constraint. It
    has no stops. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3. Refused: as for ball. */

/** - dJointSetLMotorNumAxes: Set how many axes are in use: num, held to 0 ... 3; default 0.
    - dJointGetLMotorNumAxes: How many axes are in use. [0.16] */
ODE_API void dJointSetLMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetLMotorNumAxes(dJointID joint);

/** Axis anum (0, 1, 2) and what it turns with: rel 0 the world, 1 body 1, 2 body 2 (body 1 when there is
    no body 2). (x, y, z) is in the world frame in any case. [0.16] */
ODE_API void dJointSetLMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);

/** Axis anum as it is stored: result is in the frame of the body it turns with, or in the world's. [0.16] */
ODE_API void dJointGetLMotorAxis(dJointID joint, int anum, dVector3 result);

/** - dJointSetLMotorParam: Set a parameter of one of the three motors to value: of axis 0 by the plain
      names, of axis 1 and 2 by those that end in 2 and 3.
    - dJointGetLMotorParam: The value of a parameter of one of the three motors: of axis 0 by the plain
      names, of axis 1 and 2 by those that end in 2 and 3. [0.16] */
ODE_API void dJointSetLMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetLMotorParam(dJointID joint, int parameter);

/** @chapter plane2d Plane joints: 3 rows, 3 motors

    Keeps body 1 in the world's plane z = 0, turning about z only; attach it as (body, 0). It removes
    rates of tilt, not a tilt that is there: put the body upright first, and set its orientation back now
    and then. Refused: as for ball. */

/** The plain names are meant; there are no stops.
    - dJointSetPlane2DXParam: Set a parameter of the motor along x to value.
    - dJointSetPlane2DYParam: Set a parameter of the motor along y to value.
    - dJointSetPlane2DAngleParam: Set a parameter of the motor about z to value. [0.16] */
ODE_API void dJointSetPlane2DXParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DYParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DAngleParam(dJointID joint, int parameter, dReal value);

/** @chapter pr Prismatic-rotoid joints: 4 rows, 2 limits and motors

    Body 2 turns about axis 2 through the anchor; the anchor slides along axis 1 of body 1. Set the axes
    perpendicular. Defaults: axis 1 (slide) y, axis 2 (turn) x. Parameters: the slide; the turn with names
    ending in 2. Attached as (0, body), positions, angles and their rates change sign. Refused: as for ball.
 */

/** The point on the turning axis. The position reads 0 afterwards; the angle keeps its zero. [0.16] */
ODE_API void dJointSetPRAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** It sets the zero of the angle, too.
    - dJointSetPRAxis1: Set axis 1, along which the anchor slides.
    - dJointSetPRAxis2: Set axis 2, about which body 2 turns. [0.16] */
ODE_API void dJointSetPRAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPRAxis2(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointSetPRParam: Set a parameter of a limit and motor to value: of the slide by the plain names, of
      the turn by those that end in 2.
    - dJointGetPRParam: The value of a parameter of a limit and motor: of the slide by the plain names, of
      the turn by those that end in 2. [0.16] */
ODE_API void dJointSetPRParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPRParam(dJointID joint, int parameter);

/** Apply a torque (N m) about axis 2 to body 1 and the opposite to body 2, for the next step. [0.16] */
ODE_API void dJointAddPRTorque(dJointID joint, dReal torque);

/** The anchor as body 2 has it now. [0.16] */
ODE_API void dJointGetPRAnchor(dJointID joint, dVector3 result);

/** - dJointGetPRAxis1: Write the axis of the slide as body 1 has it now to result: a unit vector, world
      frame.
    - dJointGetPRAxis2: Write the axis of the turn as body 1 has it now to result: a unit vector, world
      frame. [0.16] */
ODE_API void dJointGetPRAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPRAxis2(dJointID joint, dVector3 result);

/** - dJointGetPRPosition: How far body 1's anchor is along axis 1 from body 2's, m.
    - dJointGetPRPositionRate: The rate of the position along axis 1, m/s, where body 1 does not turn: its
      angular velocity is not counted. [0.16] */
ODE_API dReal dJointGetPRPosition(dJointID joint);
ODE_API dReal dJointGetPRPositionRate(dJointID joint);

/** - dJointGetPRAngle: The rotation of body 1 relative to body 2 about axis 2, rad, within [-pi, pi].
    - dJointGetPRAngleRate: The rate of the angle about axis 2, rad/s. [0.16] */
ODE_API dReal dJointGetPRAngle(dJointID joint);
ODE_API dReal dJointGetPRAngleRate(dJointID joint);

/** @chapter pu Prismatic-universal joints: 3 rows, 3 limits and motors

    A universal joint (axis 1 of body 1, axis 2 of body 2, kept perpendicular) whose anchor slides along a
    third axis of body 1. Defaults: axis 1 y, axis 2 z, axis 3 x. Parameters: axis 1; axis 2 and the slide
    (axis 3) with names ending in 2 and 3. Attached as (0, body), axes 1 and 2 and their angles change
    places, and the position changes sign. Refused: as for ball. */

/** The point where axes 1 and 2 meet. The position and the angles read 0 afterwards. [0.16] */
ODE_API void dJointSetPUAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetPUAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position reads
    axis 3 . (dx, dy, dz). [0.16] */
ODE_API void dJointSetPUAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz);

/** Old form: the position reads -axis 3 . (dx, dy, dz), m, or plus when attached as (0, body). [0.16] */
ODE_API_DEPRECATED ODE_API void dJointSetPUAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal dx,
                                                       dReal dy, dReal dz);

/** - dJointSetPUAxis1: Set axis 1 of the universal joint, which moves with body 1. It sets the zeros of the
      angles, too.
    - dJointSetPUAxis2: Set axis 2 of the universal joint, which moves with body 2. It sets the zeros of the
      angles, too.
    - dJointSetPUAxis3: Set axis 3, along which the anchor slides.
    - dJointSetPUAxisP: Another name of dJointSetPUAxis3: set the axis along which the anchor slides. [0.16]
 */
ODE_API void dJointSetPUAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis3(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxisP(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointSetPUParam: Set a parameter of a limit and motor to value: of axis 1 by the plain names, of axis
      2 and the slide by those that end in 2 and 3.
    - dJointGetPUParam: The value of a parameter of a limit and motor: of axis 1 by the plain names, of axis
      2 and the slide by those that end in 2 and 3. [0.16] */
ODE_API void dJointSetPUParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPUParam(dJointID joint, int parameter);

/** The anchor as body 2 has it now. [0.16] */
ODE_API void dJointGetPUAnchor(dJointID joint, dVector3 result);

/** - dJointGetPUAxis1: Write axis 1 of the universal joint as body 1 has it now to result: a unit vector,
      world frame.
    - dJointGetPUAxis2: Write axis 2 of the universal joint as body 2 has it now to result: a unit vector,
      world frame.
    - dJointGetPUAxis3: Write axis 3, of the slide, as body 1 has it now to result: a unit vector, world
      frame.
    - dJointGetPUAxisP: Another name of dJointGetPUAxis3: write the axis of the slide to result, a unit
      vector, world frame. [0.16] */
ODE_API void dJointGetPUAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis2(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis3(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxisP(dJointID joint, dVector3 result);

/** - dJointGetPUPosition: How far body 1's anchor is along axis 3 from body 2's, m.
    - dJointGetPUPositionRate: The rate of the position along axis 3, m/s, where body 2 does not turn: its
      angular velocity is counted with the opposite sign. [0.16] */
ODE_API dReal dJointGetPUPosition(dJointID joint);
ODE_API dReal dJointGetPUPositionRate(dJointID joint);

/** - dJointGetPUAngles: Write the angles about axis 1 and axis 2 to *angle1 and *angle2: rad, as of the
      universal joint. Neither pointer may be null.
    - dJointGetPUAngle1: The angle about axis 1, rad, as of the universal joint.
    - dJointGetPUAngle1Rate: The rate of the angle about axis 1, rad/s.
    - dJointGetPUAngle2: The angle about axis 2, rad, as of the universal joint.
    - dJointGetPUAngle2Rate: The rate of the angle about axis 2, rad/s. [0.16] */
ODE_API void dJointGetPUAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetPUAngle1(dJointID joint);
ODE_API dReal dJointGetPUAngle1Rate(dJointID joint);
ODE_API dReal dJointGetPUAngle2(dJointID joint);
ODE_API dReal dJointGetPUAngle2Rate(dJointID joint);

/** @chapter piston Pistons: 4 rows, 2 limits and motors

    Body 1 slides along one axis and turns about it. Default axis x. Parameters: the slide; the turn with
    names ending in 2. Attached as (0, body), positions, angles and their rates change sign. Refused: as for
    ball. */

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

/** - dJointSetPistonParam: Set a parameter of a limit and motor to value: of the slide by the plain names,
      of the turn by those that end in 2.
    - dJointGetPistonParam: The value of a parameter of a limit and motor: of the slide by the plain names,
      of the turn by those that end in 2. [0.16] */
ODE_API void dJointSetPistonParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetPistonParam(dJointID joint, int parameter);

/** Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step: on each of
    two bodies at its anchor, on one body at its centre. [0.16] */
ODE_API void dJointAddPistonForce(dJointID joint, dReal force);

/** - dJointGetPistonAnchor: Write the anchor as body 1 has it now to result, m, world frame.
    - dJointGetPistonAnchor2: Write the anchor as body 2 has it now to result, m, world frame. [0.16] */
ODE_API void dJointGetPistonAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetPistonAnchor2(dJointID joint, dVector3 result);

/** The axis as body 1 has it now, a unit vector. [0.16] */
ODE_API void dJointGetPistonAxis(dJointID joint, dVector3 result);

/** - dJointGetPistonPosition: How far body 1's anchor is along the axis from body 2's, m.
    - dJointGetPistonPositionRate: The velocity along the axis of body 1's centre relative to body 2's, m/s.
      [0.16] */
ODE_API dReal dJointGetPistonPosition(dJointID joint);
ODE_API dReal dJointGetPistonPositionRate(dJointID joint);

/** - dJointGetPistonAngle: The rotation of body 1 relative to body 2 about the axis, rad, within [-pi, pi].
    - dJointGetPistonAngleRate: The rate of the angle about the axis, rad/s. [0.16] */
ODE_API dReal dJointGetPistonAngle(dJointID joint);
ODE_API dReal dJointGetPistonAngleRate(dJointID joint);

/** @chapter dball Double ball joints: 1 row

    Keeps the distance between a point of body 1 and a point of body 2: a rod with a ball joint at each
    end, which pulls and pushes. Parameters: dParamERP, dParamCFM. Refused: as for ball. */

/** The present distance becomes the one to keep, as when the joint is attached.
    - dJointSetDBallAnchor1: Set the point of body 1, world frame.
    - dJointSetDBallAnchor2: Set the point of body 2, world frame. [0.16] */
ODE_API void dJointSetDBallAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointSetDBallDistance: Set the distance to keep, m; a negative one is refused.
    - dJointGetDBallDistance: The distance to keep, m, which need not be the present one. [0.16] */
ODE_API void dJointSetDBallDistance(dJointID joint, dReal distance);
ODE_API dReal dJointGetDBallDistance(dJointID joint);

/** - dJointSetDBallParam: Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
      the world.
    - dJointGetDBallParam: The value of a parameter of the joint: dParamERP or dParamCFM. [0.16] */
ODE_API void dJointSetDBallParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetDBallParam(dJointID joint, int parameter);

/** - dJointGetDBallAnchor1: Write where the point of body 1 is now to result, m, world frame.
    - dJointGetDBallAnchor2: Write where the point of body 2 is now to result, m, world frame. [0.16] */
ODE_API void dJointGetDBallAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetDBallAnchor2(dJointID joint, dVector3 result);

/** @chapter dhinge Double hinge joints: 4 rows

    A bar with a hinge at each end, the hinges being parallel: keeps an axis common to both bodies, the
    distance between a point of each, and their offset along the axis. Parameters: dParamERP, dParamCFM
    (of the distance). Refused: as for ball. */

/** The common axis. Needs a body; before it is called the joint keeps no axis. [0.16] */
ODE_API void dJointSetDHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** The present distance becomes the one to keep, as when the joint is attached.
    - dJointSetDHingeAnchor1: Set the point of body 1, world frame.
    - dJointSetDHingeAnchor2: Set the point of body 2, world frame. [0.16] */
ODE_API void dJointSetDHingeAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDHingeAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** - dJointSetDHingeParam: Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
      the world.
    - dJointGetDHingeParam: The value of a parameter of the joint: dParamERP or dParamCFM. [0.16] */
ODE_API void dJointSetDHingeParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetDHingeParam(dJointID joint, int parameter);

/** - dJointGetDHingeAxis: Write the common axis as body 1 has it now to result: a unit vector, world frame.
    - dJointGetDHingeAnchor1: Write where the point of body 1 is now to result, m, world frame.
    - dJointGetDHingeAnchor2: Write where the point of body 2 is now to result, m, world frame. [0.16] */
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

    Attaching to one body only is refused.

    Refused: as for ball; [dJointSetTransmission] what belongs to another mode
    than the joint's. */

/** - dJointSetTransmissionMode: Set what kind of wheels the joint couples: mode is dTransmissionParallelAxes
      (default), dTransmissionIntersectingAxes or dTransmissionChainDrive; another one is refused.
    - dJointGetTransmissionMode: What kind of wheels the joint couples: dTransmissionParallelAxes,
      dTransmissionIntersectingAxes or dTransmissionChainDrive. [0.16] */
ODE_API void dJointSetTransmissionMode(dJointID joint, int mode);
ODE_API int dJointGetTransmissionMode(dJointID joint);

/** - dJointSetTransmissionAnchor1: Set the centre of wheel 1; at first the centre of body 1.
    - dJointSetTransmissionAnchor2: Set the centre of wheel 2; at first the centre of body 2.
    - dJointGetTransmissionAnchor1: Write the centre of wheel 1 to result, m, world frame.
    - dJointGetTransmissionAnchor2: Write the centre of wheel 2 to result, m, world frame. [0.16] */
ODE_API void dJointSetTransmissionAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAnchor2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAnchor2(dJointID joint, dVector3 result);

/** - dJointSetTransmissionAxis: Set the axis of both wheels; refused with intersecting axes. Default: x of
      each body.
    - dJointGetTransmissionAxis: Write the axis of both wheels to result: a unit vector, world frame. [0.16]
 */
ODE_API void dJointSetTransmissionAxis(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis(dJointID joint, dVector3 result);

/** - dJointSetTransmissionAxis1: Set the axis of wheel 1; allowed with intersecting axes only.
    - dJointSetTransmissionAxis2: Set the axis of wheel 2; allowed with intersecting axes only.
    - dJointGetTransmissionAxis1: Write the axis of wheel 1 to result: a unit vector, world frame.
    - dJointGetTransmissionAxis2: Write the axis of wheel 2 to result: a unit vector, world frame. [0.16] */
ODE_API void dJointSetTransmissionAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAxis2(dJointID joint, dVector3 result);

/** - dJointSetTransmissionRatio: Set the ratio radius 1 / radius 2, positive; allowed with parallel axes
      only. Default 1.
    - dJointGetTransmissionRatio: The ratio radius 1 / radius 2. [0.16] */
ODE_API void dJointSetTransmissionRatio(dJointID joint, dReal ratio);
ODE_API dReal dJointGetTransmissionRatio(dJointID joint);

/** Without radii a chain does nothing; in the other modes they follow from the geometry.
    - dJointSetTransmissionRadius1: Set the radius of wheel 1, m, positive; allowed for a chain only.
    - dJointSetTransmissionRadius2: Set the radius of wheel 2, m, positive; allowed for a chain only.
    - dJointGetTransmissionRadius1: The radius of wheel 1, m: as set for a chain, else as measured by the
      first step.
    - dJointGetTransmissionRadius2: The radius of wheel 2, m: as set for a chain, else as measured by the
      first step. [0.16] */
ODE_API void dJointSetTransmissionRadius1(dJointID joint, dReal radius);
ODE_API void dJointSetTransmissionRadius2(dJointID joint, dReal radius);
ODE_API dReal dJointGetTransmissionRadius1(dJointID joint);
ODE_API dReal dJointGetTransmissionRadius2(dJointID joint);

/** - dJointSetTransmissionBacklash: Set the backlash: the free play of the rims to either side of zero slip,
      m; default 0. A negative one is refused.
    - dJointGetTransmissionBacklash: The backlash: the free play of the rims to either side of zero slip, m.
      [0.16] */
ODE_API void dJointSetTransmissionBacklash(dJointID joint, dReal backlash);
ODE_API dReal dJointGetTransmissionBacklash(dJointID joint);

/** - dJointSetTransmissionParam: Set a parameter of the joint to value: dParamERP or dParamCFM, at first
      those of the world.
    - dJointGetTransmissionParam: The value of a parameter of the joint: dParamERP or dParamCFM. [0.16] */
ODE_API void dJointSetTransmissionParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetTransmissionParam(dJointID joint, int parameter);

/** It is what the last step began with.
    - dJointGetTransmissionAngle1: How far the point of contact has run around wheel 1, as body 1 sees it,
      about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    - dJointGetTransmissionAngle2: How far the point of contact has run around wheel 2, as body 2 sees it,
      about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    - dJointGetTransmissionContactPoint1: Write where wheel 1 touched the other wheel or the chain to result,
      m, world frame.
    - dJointGetTransmissionContactPoint2: Write where wheel 2 touched the other wheel or the chain to result,
      m, world frame. [0.16] */
ODE_API dReal dJointGetTransmissionAngle1(dJointID joint);
ODE_API dReal dJointGetTransmissionAngle2(dJointID joint);
ODE_API void dJointGetTransmissionContactPoint1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionContactPoint2(dJointID joint, dVector3 result);

#ifdef __cplusplus
}
#endif

#endif
