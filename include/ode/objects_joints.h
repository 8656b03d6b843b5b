// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint types one by one: anchors, axes, readings, parameters, forces. Included by objects.h, which has
// what all joints share (creation, attachment, feedback); programs include that one or ode.h.
//
// Body 1 and body 2 are those of dJointAttach, in its order. Each section names the rows that the joint
// always has and the axes that may carry a limit and a motor. Conventions of objects.h hold: world frame, SI
// units, radians; getters of a joint without bodies leave vectors alone and answer 0.
#ifndef _ODE_OBJECTS_JOINTS_H_
#define _ODE_OBJECTS_JOINTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Functions named dJoint...Param read and write the parameters of common.h; unknown ones are ignored
   and read as 0. The dJointAdd... functions apply a force or torque along the joint's axis to
   body 1 and the opposite to body 2, for the next step. Rates and angles count body 1 relative to body 2. */

/* ======================================================================== ball: 3 rows

   Holds a point of body 1 to a point of body 2. Parameters: dParamERP, dParamCFM. */

ODE_API void dJointSetBallAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** Sets only body 2's anchor, in body 2's frame (in the world's when there is no body 2). */
ODE_API void dJointSetBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** The anchor as body 1 (body 2) has it now, world frame; they differ by the joint's error. */
ODE_API void dJointGetBallAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetBallAnchor2(dJointID joint, dVector3 result);
ODE_API void dJointSetBallParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetBallParam(dJointID joint, int parameter);

/* ======================================================================== hinge: 5 rows + limit/motor

   A common point and a common axis. Default axis x. */

ODE_API void dJointSetHingeAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetHingeAnchor, with body 2's anchor moved by (ax, ay, az) when body 2 is the world. */
ODE_API void dJointSetHingeAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                       dReal az);
ODE_API void dJointSetHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis and shifts the zero so that the angle now reads -angle. */
ODE_API void dJointSetHingeAxisOffset(dJointID joint, dReal x, dReal y, dReal z, dReal angle);
ODE_API void dJointSetHingeParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointAddHingeTorque(dJointID joint, dReal torque);

ODE_API void dJointGetHingeAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHingeAnchor2(dJointID joint, dVector3 result);
ODE_API void dJointGetHingeAxis(dJointID joint, dVector3 result);
ODE_API dReal dJointGetHingeParam(dJointID joint, int parameter);

/** Rotation of body 1 relative to body 2 about the axis since the anchor or axis was set, within
    [-pi, pi], rad; and its rate, rad/s. Both change sign when attached as (0, body). */
ODE_API dReal dJointGetHingeAngle(dJointID joint);
ODE_API dReal dJointGetHingeAngleRate(dJointID joint);

/* ======================================================================== slider: 5 rows + limit/motor

   No relative rotation, translation along one axis only. Default axis x. It has no anchor. */

ODE_API void dJointSetSliderAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Sets the axis, with the zero position shifted by (ax, ay, az) when body 2 is the world: the
    position then reads -(axis . a). */
ODE_API void dJointSetSliderAxisDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax, dReal ay,
                                      dReal az);
ODE_API void dJointSetSliderParam(dJointID joint, int parameter, dReal value);

/** Force along the axis, N; the torque that keeps angular momentum is added too. */
ODE_API void dJointAddSliderForce(dJointID joint, dReal force);

/** How far body 1 has moved along the axis since the axis was set, m; and its rate, m/s. */
ODE_API dReal dJointGetSliderPosition(dJointID joint);
ODE_API dReal dJointGetSliderPositionRate(dJointID joint);
ODE_API void dJointGetSliderAxis(dJointID joint, dVector3 result);
ODE_API dReal dJointGetSliderParam(dJointID joint, int parameter);

/* ======================================================================== universal: 4 rows + 2
   limits/motors

   A common point, and axis 1 (of body 1) kept perpendicular to axis 2 (of body 2): a cardan joint.
   Defaults x and y. Parameters: axis 1, and axis 2 with the names ending in 2. */

ODE_API void dJointSetUniversalAnchor(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis2(dJointID joint, dReal x, dReal y, dReal z);

/** Set an axis and shift the zeros so that the angles now read offset1 and offset2. */
ODE_API void dJointSetUniversalAxis1Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);
ODE_API void dJointSetUniversalAxis2Offset(dJointID joint, dReal x, dReal y, dReal z, dReal offset1,
                                           dReal offset2);
ODE_API void dJointSetUniversalParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointAddUniversalTorques(dJointID joint, dReal torque1, dReal torque2);

ODE_API void dJointGetUniversalAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAnchor2(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetUniversalAxis2(dJointID joint, dVector3 result);
ODE_API dReal dJointGetUniversalParam(dJointID joint, int parameter);

/** Angles between each body and the cross piece about its axis, rad, and their rates, rad/s. The
    first form writes both angles. */
ODE_API void dJointGetUniversalAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetUniversalAngle1(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2(dJointID joint);
ODE_API dReal dJointGetUniversalAngle1Rate(dJointID joint);
ODE_API dReal dJointGetUniversalAngle2Rate(dJointID joint);

/* ======================================================================== hinge-2: 4 rows + 2 limits/motors

   A car wheel: body 1 is the chassis with axis 1 (steering, also the direction of the suspension),
   body 2 the wheel with axis 2 (spin). The angle between the axes is kept as set. Both bodies are
   needed. Parameters: axis 1; axis 2 with names ending in 2 (motor only, its stops are not used);
   dParamSuspensionERP and dParamSuspensionCFM for the play along axis 1. */

ODE_API void dJointSetHinge2Anchor(dJointID joint, dReal x, dReal y, dReal z);

/** Set axis 1 and axis 2, each 3 reals; NULL keeps one (not both). Two parallel axes are refused; one
   alone may be parallel to the other until that is set too (while they are, one turn is left free). */
ODE_API void dJointSetHinge2Axes(dJointID joint, const dReal* axis1, const dReal* axis2);

/** Old forms that set one axis. */
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetHinge2Param(dJointID joint, int parameter, dReal value);
ODE_API void dJointAddHinge2Torques(dJointID joint, dReal torque1, dReal torque2);

ODE_API void dJointGetHinge2Anchor(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Anchor2(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Axis1(dJointID joint, dVector3 result);
ODE_API void dJointGetHinge2Axis2(dJointID joint, dVector3 result);
ODE_API dReal dJointGetHinge2Param(dJointID joint, int parameter);

/** Steering angle of body 1 relative to body 2 about axis 1, within (-pi, pi]. */
ODE_API dReal dJointGetHinge2Angle1(dJointID joint);

/** Spin angle about axis 2, within (-pi, pi]: it grows as the wheel turns forward about axis 2. */
ODE_API dReal dJointGetHinge2Angle2(dJointID joint);

/** Rates of body 1 relative to body 2 about the axes, rad/s. Note that Angle2Rate therefore has the
    opposite sign of the change of Angle2. */
ODE_API dReal dJointGetHinge2Angle1Rate(dJointID joint);
ODE_API dReal dJointGetHinge2Angle2Rate(dJointID joint);

/* ======================================================================== fixed: 6 rows

   Holds the relative pose. Two bodies that never part are better one body. Parameters: dParamERP
   and dParamCFM, of the linear rows. */

/** Take the current relative pose as the one to keep. Call it after attaching: attaching alone does
    not. */
ODE_API void dJointSetFixed(dJointID joint);
ODE_API void dJointSetFixedParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetFixedParam(dJointID joint, int parameter);

/* ======================================================================== angular motor: up to 3 rows

   Motors and stops on relative rotation about up to three axes; no other constraint. Often used on top of
   a ball joint. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3. */

/** dAMotorUser (default): the program sets axes and, for stops, angles. dAMotorEuler: three axes,
    of which the program sets axis 0 (fixed in body 1) and axis 2 (fixed in body 2), perpendicular
    at that time; axis 1 and the Euler angles follow. */
ODE_API void dJointSetAMotorMode(dJointID joint, int mode);
ODE_API int dJointGetAMotorMode(dJointID joint);

/** Axes in use, 0 ... 3, default 0; in Euler mode always 3. */
ODE_API void dJointSetAMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetAMotorNumAxes(dJointID joint);

/** Axis anum (0, 1, 2) and what it moves with: rel 0 the world, 1 body 1, 2 body 2. (x, y, z) is in
    the world frame in any case. */
ODE_API void dJointSetAMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);
ODE_API void dJointGetAMotorAxis(dJointID joint, int anum, dVector3 result);
ODE_API int dJointGetAMotorAxisRel(dJointID joint, int anum);

/** The angle that stops are compared with. User mode: what the program says, before each step; setting is
    refused in Euler mode, where the last step's Euler angles are given. */
ODE_API void dJointSetAMotorAngle(dJointID joint, int anum, dReal angle);
ODE_API dReal dJointGetAMotorAngle(dJointID joint, int anum);

/** Relative angular velocity about axis anum, rad/s. */
ODE_API dReal dJointGetAMotorAngleRate(dJointID joint, int anum);
ODE_API void dJointSetAMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetAMotorParam(dJointID joint, int parameter);

/** Torques about the axes in use, N m. */
ODE_API void dJointAddAMotorTorques(dJointID joint, dReal torque1, dReal torque2, dReal torque3);

/* ======================================================================== linear motor: up to 3 rows

   Motors on the relative velocity of the bodies' centres along up to three axes; no other constraint. It has
   no stops. Parameters of axis 0, 1, 2: plain names, names ending in 2, in 3. */

/** Axes in use, 0 ... 3, default 0. */
ODE_API void dJointSetLMotorNumAxes(dJointID joint, int num);
ODE_API int dJointGetLMotorNumAxes(dJointID joint);

/** Axis anum (0, 1, 2) and what it turns with: rel 0 the world, 1 body 1, 2 body 2 (body 1 when there is no
    body 2). (x, y, z) is in the world frame in any case. */
ODE_API void dJointSetLMotorAxis(dJointID joint, int anum, int rel, dReal x, dReal y, dReal z);

/** The axis as it is stored: in the frame of the body it turns with, or in the world's. */
ODE_API void dJointGetLMotorAxis(dJointID joint, int anum, dVector3 result);
ODE_API void dJointSetLMotorParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetLMotorParam(dJointID joint, int parameter);

/* ======================================================================== plane: 3 rows + 3 motors

   Keeps body 1 in the world's plane z = 0, turning about z only; attach it as (body, 0). It removes rates of
   tilt, not a tilt that is there: put the body upright first, and set its orientation back now and then. Its
   motors work along x, along y and about z; they have no stops. Parameters: the plain names. */

ODE_API void dJointSetPlane2DXParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DYParam(dJointID joint, int parameter, dReal value);
ODE_API void dJointSetPlane2DAngleParam(dJointID joint, int parameter, dReal value);

/* ======================================================================== prismatic-rotoid: 4 rows + 2
   limits/motors

   Body 2 turns about axis 2 through the anchor; the anchor slides along axis 1 of body 1. Set the axes
   perpendicular. Defaults: axis 1 (slide) y, axis 2 (turn) x. Parameters: the slide; the turn with names
   ending in 2. Attached as (0, body), positions, angles and their rates change sign. */

/** The position reads 0 afterwards; the angle keeps its zero. */
ODE_API void dJointSetPRAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** Both set the zero of the angle, too. */
ODE_API void dJointSetPRAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPRAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPRParam(dJointID joint, int parameter, dReal value);

/** Torque about axis 2, N m. */
ODE_API void dJointAddPRTorque(dJointID joint, dReal torque);

/** The anchor as body 2 has it. */
ODE_API void dJointGetPRAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetPRAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPRAxis2(dJointID joint, dVector3 result);
ODE_API dReal dJointGetPRParam(dJointID joint, int parameter);

/** How far body 1's anchor is along axis 1 from body 2's, m; and how fast that changes, m/s. */
ODE_API dReal dJointGetPRPosition(dJointID joint);
ODE_API dReal dJointGetPRPositionRate(dJointID joint);

/** Rotation of body 1 relative to body 2 about axis 2, within [-pi, pi], rad; and its rate, rad/s. */
ODE_API dReal dJointGetPRAngle(dJointID joint);
ODE_API dReal dJointGetPRAngleRate(dJointID joint);

/* ======================================================================== prismatic-universal: 3 rows + 3
   limits/motors

   A universal joint (axis 1 of body 1, axis 2 of body 2, kept perpendicular) whose anchor slides along a
   third axis of body 1. Defaults: axis 1 y, axis 2 z, axis 3 x. Parameters: axis 1; axis 2 and the slide
   (axis 3) with names ending in 2 and 3. Attached as (0, body), axes 1 and 2 and their angles change places,
   and the position changes sign. */

/** The position and the angles read 0 afterwards. */
ODE_API void dJointSetPUAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetPUAnchor, as if the bodies had come apart by (dx, dy, dz) since: the position reads
    axis 3 . (dx, dy, dz). */
ODE_API void dJointSetPUAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy, dReal dz);

/** Old form: the position reads -axis 3 . (dx, dy, dz), or plus when attached as (0, body). */
ODE_API_DEPRECATED ODE_API void dJointSetPUAnchorDelta(dJointID joint, dReal x, dReal y, dReal z, dReal dx,
                                                       dReal dy, dReal dz);

/** The first two set the zeros of the angles, too. */
ODE_API void dJointSetPUAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUAxis3(dJointID joint, dReal x, dReal y, dReal z);

/** Same as dJointSetPUAxis3. */
ODE_API void dJointSetPUAxisP(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetPUParam(dJointID joint, int parameter, dReal value);

/** The anchor as body 2 has it. */
ODE_API void dJointGetPUAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis2(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxis3(dJointID joint, dVector3 result);
ODE_API void dJointGetPUAxisP(dJointID joint, dVector3 result);
ODE_API dReal dJointGetPUParam(dJointID joint, int parameter);

/** How far body 1's anchor is along axis 3 from body 2's, m; and how fast that changes, m/s. */
ODE_API dReal dJointGetPUPosition(dJointID joint);
ODE_API dReal dJointGetPUPositionRate(dJointID joint);

/** Angles and rates about axis 1 and axis 2, as of the universal joint. The first form writes both angles. */
ODE_API void dJointGetPUAngles(dJointID joint, dReal* angle1, dReal* angle2);
ODE_API dReal dJointGetPUAngle1(dJointID joint);
ODE_API dReal dJointGetPUAngle1Rate(dJointID joint);
ODE_API dReal dJointGetPUAngle2(dJointID joint);
ODE_API dReal dJointGetPUAngle2Rate(dJointID joint);

/* ======================================================================== piston: 4 rows + 2 limits/motors

   Body 1 slides along one axis and turns about it. Default axis x. Parameters: the slide; the turn with names
   ending in 2. Attached as (0, body), positions, angles and their rates change sign. */

/** The position and the angle read 0 afterwards. */
ODE_API void dJointSetPistonAnchor(dJointID joint, dReal x, dReal y, dReal z);

/** As dJointSetPistonAnchor, as if the bodies had come apart by (dx, dy, dz) since: the position reads
    axis . (dx, dy, dz). */
ODE_API void dJointSetPistonAnchorOffset(dJointID joint, dReal x, dReal y, dReal z, dReal dx, dReal dy,
                                         dReal dz);

/** Sets the zero of the angle, too. */
ODE_API void dJointSetPistonAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Old form of little use: sets the axis, and the vector from body 1 to its anchor to the position of body 1
    relative to body 2 (to the world) minus (ax, ay, az). Use dJointSetPistonAnchorOffset. */
ODE_API_DEPRECATED ODE_API void dJointSetPistonAxisDelta(dJointID joint, dReal x, dReal y, dReal z, dReal ax,
                                                         dReal ay, dReal az);
ODE_API void dJointSetPistonParam(dJointID joint, int parameter, dReal value);

/** Force along the axis, N, acting on each of two bodies at its anchor, on one body at its centre. */
ODE_API void dJointAddPistonForce(dJointID joint, dReal force);

/** The anchor as body 1 (body 2) has it now. */
ODE_API void dJointGetPistonAnchor(dJointID joint, dVector3 result);
ODE_API void dJointGetPistonAnchor2(dJointID joint, dVector3 result);
ODE_API void dJointGetPistonAxis(dJointID joint, dVector3 result);
ODE_API dReal dJointGetPistonParam(dJointID joint, int parameter);

/** How far body 1's anchor is along the axis from body 2's, m; and the velocity along the axis of body 1's
   centre relative to body 2's, m/s. */
ODE_API dReal dJointGetPistonPosition(dJointID joint);
ODE_API dReal dJointGetPistonPositionRate(dJointID joint);

/** Rotation of body 1 relative to body 2 about the axis, within [-pi, pi], rad; and its rate, rad/s. */
ODE_API dReal dJointGetPistonAngle(dJointID joint);
ODE_API dReal dJointGetPistonAngleRate(dJointID joint);

/* ======================================================================== double ball: 1 row

   Keeps the distance between a point of body 1 and a point of body 2: a rod with a ball joint at each end,
   which pulls and pushes. Parameters: dParamERP, dParamCFM. */

/** Each sets the point of one body and takes the present distance as the one to keep, as attaching does. */
ODE_API void dJointSetDBallAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDBallAnchor2(dJointID joint, dReal x, dReal y, dReal z);

/** The distance to keep, m, not negative. */
ODE_API void dJointSetDBallDistance(dJointID joint, dReal distance);
ODE_API void dJointSetDBallParam(dJointID joint, int parameter, dReal value);

ODE_API void dJointGetDBallAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetDBallAnchor2(dJointID joint, dVector3 result);

/** The distance to keep, not the present one. */
ODE_API dReal dJointGetDBallDistance(dJointID joint);
ODE_API dReal dJointGetDBallParam(dJointID joint, int parameter);

/* ======================================================================== double hinge: 4 rows

   A bar with a hinge at each end, the hinges being parallel: keeps an axis common to both bodies, the
   distance between a point of each, and their offset along the axis. Parameters: dParamERP, dParamCFM (of the
   distance). */

/** Needs a body; before it is called the joint keeps no axis. */
ODE_API void dJointSetDHingeAxis(dJointID joint, dReal x, dReal y, dReal z);

/** Each sets the point of one body and takes the present distance as the one to keep, as attaching does. */
ODE_API void dJointSetDHingeAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDHingeAnchor2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetDHingeParam(dJointID joint, int parameter, dReal value);

ODE_API void dJointGetDHingeAxis(dJointID joint, dVector3 result);
ODE_API void dJointGetDHingeAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetDHingeAnchor2(dJointID joint, dVector3 result);

/** The distance to keep, m. */
ODE_API dReal dJointGetDHingeDistance(dJointID joint);
ODE_API dReal dJointGetDHingeParam(dJointID joint, int parameter);

/* ======================================================================== transmission: 1 row

   Two wheels whose rims do not slip: gears, bevel gears, or wheels with a chain around them, by mode
   (common.h). Wheel i turns with body i about axis i through anchor i; hinges to hold it there are the
   program's business. Both bodies are needed. Parameters: dParamERP, dParamCFM.
     dTransmissionParallelAxes (default): gears in contact between the anchors, turning in opposite senses.
   Give one axis and the ratio of the radii. dTransmissionIntersectingAxes: bevel gears. Give two axes; each
   wheel lies in the plane across its axis through its anchor, and contact is where the planes meet. Radii and
   ratio follow. dTransmissionChainDrive: a chain around both wheels, which turn in one sense. Give one axis
   and the radii. A step after axes, anchors, mode or bodies have been set starts the angles at zero; after
   ratio or radii have been set, what slip there is becomes zero. Should axes point against each other, axis 1
   is turned round then. */

/** Other than the three modes is refused. */
ODE_API void dJointSetTransmissionMode(dJointID joint, int mode);
ODE_API int dJointGetTransmissionMode(dJointID joint);

/** Centres of the wheels; at first the centres of the bodies. */
ODE_API void dJointSetTransmissionAnchor1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAnchor2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAnchor1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAnchor2(dJointID joint, dVector3 result);

/** The axis of both wheels; not with intersecting axes. Default: x of each body. */
ODE_API void dJointSetTransmissionAxis(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis(dJointID joint, dVector3 result);

/** The axis of one wheel; to be set with intersecting axes only. */
ODE_API void dJointSetTransmissionAxis1(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointSetTransmissionAxis2(dJointID joint, dReal x, dReal y, dReal z);
ODE_API void dJointGetTransmissionAxis1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionAxis2(dJointID joint, dVector3 result);

/** Radius 1 / radius 2, positive; to be set with parallel axes only. Default 1. */
ODE_API void dJointSetTransmissionRatio(dJointID joint, dReal ratio);
ODE_API dReal dJointGetTransmissionRatio(dJointID joint);

/** Radii, m, positive; to be set for a chain only, else as measured by the first step. Without radii a chain
    does nothing. */
ODE_API void dJointSetTransmissionRadius1(dJointID joint, dReal radius);
ODE_API void dJointSetTransmissionRadius2(dJointID joint, dReal radius);
ODE_API dReal dJointGetTransmissionRadius1(dJointID joint);
ODE_API dReal dJointGetTransmissionRadius2(dJointID joint);

/** Free play of the rims to either side of zero slip, m, default 0, not negative. */
ODE_API void dJointSetTransmissionBacklash(dJointID joint, dReal backlash);
ODE_API dReal dJointGetTransmissionBacklash(dJointID joint);
ODE_API void dJointSetTransmissionParam(dJointID joint, int parameter, dReal value);
ODE_API dReal dJointGetTransmissionParam(dJointID joint, int parameter);

/** What the last step began with: how far the point of contact has run around each wheel, as its body sees
   it, about its axis, rad (a wheel that turns forward counts backward; full turns add up); and where the
   wheels, or wheel and chain, touched. */
ODE_API dReal dJointGetTransmissionAngle1(dJointID joint);
ODE_API dReal dJointGetTransmissionAngle2(dJointID joint);
ODE_API void dJointGetTransmissionContactPoint1(dJointID joint, dVector3 result);
ODE_API void dJointGetTransmissionContactPoint2(dJointID joint, dVector3 result);

#ifdef __cplusplus
}
#endif

#endif
