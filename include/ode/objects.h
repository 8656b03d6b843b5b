// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dynamics: worlds, rigid bodies, joints of all types, and the functions that move them in time. What belongs
// to one type of joint is in objects_joints.h, which this file includes: programs written for ODE know one.
//
// A step of size h solves for the joint forces lambda (N, N m) of each island of connected bodies
//     (J M^-1 J^T + CFM/h) lambda = rhs,   lo <= lambda <= hi,   J v+ = ERP/h * error - CFM lambda,
// then moves velocities and positions on by h (velocities first: semi-implicit Euler). ERP is the
// part of a joint's position error that is corrected per step, CFM its softness. A spring of stiffness
// kp with damping kd is ERP = h kp / (h kp + kd), CFM = 1 / (h kp + kd).
//
// Unless said otherwise: positions, vectors and forces are in the world frame and in SI units,
// angles in radians; NaN and infinities are refused where a finite number is meant; a call on a null
// or wrong object is refused (error.h); getters that fill a vector write 3 components.
#ifndef _ODE_OBJECTS_H_
#define _ODE_OBJECTS_H_

#include <ode/common.h>
#include <ode/contact.h>
#include <ode/mass.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ======================================================================== worlds */

/** A new, empty world with no gravity. */
ODE_API dWorldID dWorldCreate(void);

/** Destroy a world with all its bodies and all its joints that are in no joint group. Geoms survive
    without a body. Joints in groups lose their world and bodies (a message is sent for each) and go with
   their group. */
ODE_API void dWorldDestroy(dWorldID world);

/** A pointer of the program's, NULL at first; the library never looks at it. */
ODE_API void dWorldSetData(dWorldID world, void* data);
ODE_API void* dWorldGetData(dWorldID world);

/** Gravity, m/s^2, default (0, 0, 0). Acts on every body whose gravity mode is on. */
ODE_API void dWorldSetGravity(dWorldID world, dReal x, dReal y, dReal z);
ODE_API void dWorldGetGravity(dWorldID world, dVector3 gravity);

/** The world's error reduction: part of joint errors corrected per step, sensibly 0.1 ... 0.8,
    default 0.2. Joints use the current value, except those parameters that a joint copies when it
    is created (dParamERP, dParamStopERP, dParamSuspensionERP). */
ODE_API void dWorldSetERP(dWorldID world, dReal erp);
ODE_API dReal dWorldGetERP(dWorldID world);

/** The world's constraint softness, sensibly 1e-9 ... 1, default 1e-10 (1e-5 in single
    precision). Copied by joints like ERP. */
ODE_API void dWorldSetCFM(dWorldID world, dReal cfm);
ODE_API dReal dWorldGetCFM(dWorldID world);

/** Most threads that work on islands in a step; 0 (the default, dWORLDSTEP_THREADCOUNT_UNLIMITED) sets no
   limit. It is a limit only: a world that has been given no threads steps on the calling thread. */
#define dWORLDSTEP_THREADCOUNT_UNLIMITED dTHREADING_THREAD_COUNT_UNLIMITED
ODE_API void dWorldSetStepIslandsProcessingMaxThreadCount(dWorldID world, unsigned count);
ODE_API unsigned dWorldGetStepIslandsProcessingMaxThreadCount(dWorldID world);

/** How step memory is reserved: room for reserve_factor times what is needed, at least
    reserve_minimum bytes. struct_size: sizeof of the struct, set by the caller. */
#define dWORLDSTEP_RESERVEFACTOR_DEFAULT 1.2f
#define dWORLDSTEP_RESERVESIZE_DEFAULT 65536U
typedef struct {
    unsigned struct_size;
    float reserve_factor;
    unsigned reserve_minimum;
} dWorldStepReserveInfo;

/** Where step memory comes from. struct_size: sizeof of the struct, set by the caller. */
typedef struct {
    unsigned struct_size;
    void* (*alloc_block)(dsizeint block_size);
    void* (*shrink_block)(void* block_pointer, dsizeint block_current_size, dsizeint block_smaller_size);
    void (*free_block)(void* block_pointer, dsizeint block_current_size);
} dWorldStepMemoryFunctionsInfo;

/* ---- stepping ---- */

/** Advance by stepsize seconds with the exact solver: the mixed complementarity problem of each
    island is solved to rounding. Friction limits are taken from the normal forces of the frictionless
    solution. Time grows with the cube, memory with the square of the constraint rows in an island.
    Order: auto-disable test; islands; per island forces, rows, solution, new velocities, new
    positions, moved callbacks. Force and torque accumulators of stepped bodies are zero afterwards.
    Returns 1; 0 when refused (stepsize not positive and finite) or out of memory, the world then
    being where it was. */
ODE_API int dWorldStep(dWorldID world, dReal stepsize);

/** The same step with the iterative solver (projected successive over-relaxation): time and memory
    linear in the rows. Friction limits follow the normal forces during the iteration. */
ODE_API int dWorldQuickStep(dWorldID world, dReal stepsize);

/** The constant force that gives the impulse (ix, iy, iz), N s, within one step: impulse / stepsize. */
ODE_API void dWorldImpulseToForce(dWorldID world, dReal stepsize, dReal ix, dReal iy, dReal iz,
                                  dVector3 force);

/** Iterations of dWorldQuickStep, default 20. 0 or less lets the joints exert no force. */
ODE_API void dWorldSetQuickStepNumIterations(dWorldID world, int num);
ODE_API int dWorldGetQuickStepNumIterations(dWorldID world);

/** Over-relaxation of dWorldQuickStep, sensibly within (0, 2), default 1.3. */
ODE_API void dWorldSetQuickStepW(dWorldID world, dReal over_relaxation);
ODE_API dReal dWorldGetQuickStepW(dWorldID world);

/* ---- contacts ---- */

/** Fastest velocity (m/s) a contact may use to undo penetration, default dInfinity. Does not limit
    bouncing. */
ODE_API void dWorldSetContactMaxCorrectingVel(dWorldID world, dReal vel);
ODE_API dReal dWorldGetContactMaxCorrectingVel(dWorldID world);

/** Penetration (m) that contacts leave alone so that they persist, default 0. */
ODE_API void dWorldSetContactSurfaceLayer(dWorldID world, dReal depth);
ODE_API dReal dWorldGetContactSurfaceLayer(dWorldID world);

/* ---- automatic disabling: the values for bodies made later ----
   A body with the flag on, at least one joint, and average linear and angular speed at or below the
   thresholds is idle. When it has been idle for `steps` steps and `time` seconds it is
   disabled and its velocity set to zero. It wakes when an enabled body reaches it through a joint. */

/** Threshold of the linear speed, m/s, default 0.01. */
ODE_API void dWorldSetAutoDisableLinearThreshold(dWorldID world, dReal linear_average_threshold);
ODE_API dReal dWorldGetAutoDisableLinearThreshold(dWorldID world);

/** Threshold of the angular speed, rad/s, default 0.01. */
ODE_API void dWorldSetAutoDisableAngularThreshold(dWorldID world, dReal angular_average_threshold);
ODE_API dReal dWorldGetAutoDisableAngularThreshold(dWorldID world);

/** Over how many steps velocities are averaged (as vectors, so swinging cancels), default 1 = the
    current velocity; 0: never disable. */
ODE_API void dWorldSetAutoDisableAverageSamplesCount(dWorldID world, unsigned int average_samples_count);
ODE_API int dWorldGetAutoDisableAverageSamplesCount(dWorldID world);

/** Idle steps needed, default 10. */
ODE_API void dWorldSetAutoDisableSteps(dWorldID world, int steps);
ODE_API int dWorldGetAutoDisableSteps(dWorldID world);

/** Idle time needed, s, default 0. */
ODE_API void dWorldSetAutoDisableTime(dWorldID world, dReal time);
ODE_API dReal dWorldGetAutoDisableTime(dWorldID world);

/** Whether new bodies disable themselves, default 0. The getter answers zero or non-zero. */
ODE_API void dWorldSetAutoDisableFlag(dWorldID world, int do_auto_disable);
ODE_API int dWorldGetAutoDisableFlag(dWorldID world);

/* ---- damping and speed limit: the values for bodies made later ----
   After each step a speed above its threshold is multiplied by (1 - scale), whatever the step size. */

/** Thresholds, m/s and rad/s, default 0.01. */
ODE_API void dWorldSetLinearDampingThreshold(dWorldID world, dReal threshold);
ODE_API dReal dWorldGetLinearDampingThreshold(dWorldID world);
ODE_API void dWorldSetAngularDampingThreshold(dWorldID world, dReal threshold);
ODE_API dReal dWorldGetAngularDampingThreshold(dWorldID world);

/** Scales, sensibly 0 ... 1, default 0 = no damping. dWorldSetDamping sets both. */
ODE_API void dWorldSetLinearDamping(dWorldID world, dReal scale);
ODE_API dReal dWorldGetLinearDamping(dWorldID world);
ODE_API void dWorldSetAngularDamping(dWorldID world, dReal scale);
ODE_API dReal dWorldGetAngularDamping(dWorldID world);
ODE_API void dWorldSetDamping(dWorldID world, dReal linear_scale, dReal angular_scale);

/** Angular speed that bodies are held to, rad/s, default dInfinity. */
ODE_API void dWorldSetMaxAngularSpeed(dWorldID world, dReal max_speed);
ODE_API dReal dWorldGetMaxAngularSpeed(dWorldID world);

/* ======================================================================== bodies */

/** A new body in the world: at the origin, not rotated, at rest, mass 1 kg with unit inertia,
    enabled; gravity and gyroscopic mode on; auto-disable, damping and speed limit as the world has them now.
 */
ODE_API dBodyID dBodyCreate(dWorldID world);

/** Destroy a body. Its geoms stay where they are, without a body. Its joints stay, detached from
    both of their bodies. */
ODE_API void dBodyDestroy(dBodyID body);

ODE_API dWorldID dBodyGetWorld(dBodyID body);

/** A pointer of the program's, NULL at first. */
ODE_API void dBodySetData(dBodyID body, void* data);
ODE_API void* dBodyGetData(dBodyID body);

/* ---- pose and velocity ----
   Setters move the body at once, with its geoms; they do not wake it and call no callback. After a
   jump joints have errors, which the following steps correct. */

/** Position of the body's origin, which is its centre of mass, m. */
ODE_API void dBodySetPosition(dBodyID body, dReal x, dReal y, dReal z);

/** Orientation by matrix (made orthonormal here) or quaternion (normalised here). A zero quaternion
    or a degenerate matrix is refused. */
ODE_API void dBodySetRotation(dBodyID body, const dMatrix3 R);
ODE_API void dBodySetQuaternion(dBodyID body, const dQuaternion q);

/** Velocity of the centre of mass, m/s; angular velocity, rad/s. */
ODE_API void dBodySetLinearVel(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodySetAngularVel(dBodyID body, dReal x, dReal y, dReal z);

/** Pointers into the body: 3 (4), 12, 4 reals. They stay valid as long as the body, and show its
    current state. */
ODE_API const dReal* dBodyGetPosition(dBodyID body);
ODE_API const dReal* dBodyGetRotation(dBodyID body);
ODE_API const dReal* dBodyGetQuaternion(dBodyID body);
ODE_API const dReal* dBodyGetLinearVel(dBodyID body);
ODE_API const dReal* dBodyGetAngularVel(dBodyID body);

/** Copies of the pose: 3, 12 and 4 reals are written. */
ODE_API void dBodyCopyPosition(dBodyID body, dVector3 pos);
ODE_API void dBodyCopyRotation(dBodyID body, dMatrix3 R);
ODE_API void dBodyCopyQuaternion(dBodyID body, dQuaternion quat);

/* ---- mass and forces ---- */

/** Give the body a mass; it becomes dynamic. Refused when the centre of mass is not at the origin or
    dMassCheck says no. dBodyGetMass also works on a kinematic body, which keeps its mass in
    store. */
ODE_API void dBodySetMass(dBodyID body, const dMass* mass);
ODE_API void dBodyGetMass(dBodyID body, dMass* mass);

/** Add to the forces (N) and torques (N m) of the next step. They act during the whole step and are zeroed
    after it. "Rel" before Force / Torque: given in body axes. AtPos: the force acts at the point p
    (m) of the world, AtRelPos: at the point p of the body frame; both add the torque about the centre. */
ODE_API void dBodyAddForce(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddTorque(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddRelForce(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddRelTorque(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddForceAtPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddForceAtRelPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForceAtPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForceAtRelPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py,
                                      dReal pz);

/** The sums so far, as pointers into the body (3 reals), and setting them outright. A disabled
    body keeps its sums until it moves again. */
ODE_API const dReal* dBodyGetForce(dBodyID body);
ODE_API const dReal* dBodyGetTorque(dBodyID body);
ODE_API void dBodySetForce(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodySetTorque(dBodyID body, dReal x, dReal y, dReal z);

/* ---- points and vectors ---- */

/** World position (velocity) of the point p given in the body frame. */
ODE_API void dBodyGetRelPointPos(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dBodyGetRelPointVel(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** Velocity of the body's material at the world point p. */
ODE_API void dBodyGetPointVel(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** Body coordinates of the world point p. */
ODE_API void dBodyGetPosRelPoint(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** Turn a direction from body to world axes and back. */
ODE_API void dBodyVectorToWorld(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dBodyVectorFromWorld(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/* ---- how the body moves ---- */

/** How orientations are advanced. 0 (default): q += h/2 (0, w) q, normalised; cheap, inexact at
    high spin. Non-zero: the exact rotation by |w| h. With a finite rotation axis only the part of w
    about that axis is treated exactly. */
ODE_API void dBodySetFiniteRotationMode(dBodyID body, int mode);
ODE_API int dBodyGetFiniteRotationMode(dBodyID body);

/** The axis of fast spin, world frame, normalised here; (0, 0, 0), the default, means none. */
ODE_API void dBodySetFiniteRotationAxis(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodyGetFiniteRotationAxis(dBodyID body, dVector3 result);

/** Joints attached to the body, most recently attached first; a bad index gives 0. */
ODE_API int dBodyGetNumJoints(dBodyID body);
ODE_API dJointID dBodyGetJoint(dBodyID body, int index);

/** A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it
    acts on others as if infinitely heavy. dBodySetDynamic gives it its stored mass back. */
ODE_API void dBodySetDynamic(dBodyID body);
ODE_API void dBodySetKinematic(dBodyID body);
ODE_API int dBodyIsKinematic(dBodyID body);

/** Put a body to sleep or wake it by hand. A disabled body is not stepped until it is enabled or
    an enabled body reaches it through a joint; it keeps its velocity. Enabling restarts the idle
    counters. */
ODE_API void dBodyEnable(dBodyID body);
ODE_API void dBodyDisable(dBodyID body);
ODE_API int dBodyIsEnabled(dBodyID body);

/** Whether the world's gravity acts, default 1. */
ODE_API void dBodySetGravityMode(dBodyID body, int mode);
ODE_API int dBodyGetGravityMode(dBodyID body);

/** Whether the gyroscopic torque -w x I w is applied (by an implicit formula that is stable at any spin),
    default on. The getter answers zero or non-zero. */
ODE_API void dBodySetGyroscopicMode(dBodyID body, int enabled);
ODE_API int dBodyGetGyroscopicMode(dBodyID body);

/** A function called for every body that a step moved, after its new pose is set and before
    damping. It must not destroy the body or change the world's structure. NULL (default): none. */
ODE_API void dBodySetMovedCallback(dBodyID body, void (*callback)(dBodyID));

/** The geoms of a body, most recently attached first; 0 at the end. */
ODE_API dGeomID dBodyGetFirstGeom(dBodyID body);
ODE_API dGeomID dBodyGetNextGeom(dGeomID geom);

/* ---- automatic disabling of one body: see the world's functions ---- */

ODE_API void dBodySetAutoDisableLinearThreshold(dBodyID body, dReal linear_average_threshold);
ODE_API dReal dBodyGetAutoDisableLinearThreshold(dBodyID body);
ODE_API void dBodySetAutoDisableAngularThreshold(dBodyID body, dReal angular_average_threshold);
ODE_API dReal dBodyGetAutoDisableAngularThreshold(dBodyID body);

/** Changing the count throws the samples gathered so far away. */
ODE_API void dBodySetAutoDisableAverageSamplesCount(dBodyID body, unsigned int average_samples_count);
ODE_API int dBodyGetAutoDisableAverageSamplesCount(dBodyID body);

/** New values count from the next restart of the idle counters. */
ODE_API void dBodySetAutoDisableSteps(dBodyID body, int steps);
ODE_API int dBodyGetAutoDisableSteps(dBodyID body);
ODE_API void dBodySetAutoDisableTime(dBodyID body, dReal time);
ODE_API dReal dBodyGetAutoDisableTime(dBodyID body);

/** Switch automatic disabling on or off. Off also enables the body and takes steps, time and sample count
   over from the world. */
ODE_API void dBodySetAutoDisableFlag(dBodyID body, int do_auto_disable);
ODE_API int dBodyGetAutoDisableFlag(dBodyID body);

/** Take all auto-disable settings over from the world. */
ODE_API void dBodySetAutoDisableDefaults(dBodyID body);

/* ---- damping and speed limit of one body: see the world's functions ---- */

/** Take all damping settings over from the world. */
ODE_API void dBodySetDampingDefaults(dBodyID body);
ODE_API void dBodySetLinearDamping(dBodyID body, dReal scale);
ODE_API dReal dBodyGetLinearDamping(dBodyID body);
ODE_API void dBodySetAngularDamping(dBodyID body, dReal scale);
ODE_API dReal dBodyGetAngularDamping(dBodyID body);
ODE_API void dBodySetDamping(dBodyID body, dReal linear_scale, dReal angular_scale);
ODE_API void dBodySetLinearDampingThreshold(dBodyID body, dReal threshold);
ODE_API dReal dBodyGetLinearDampingThreshold(dBodyID body);
ODE_API void dBodySetAngularDampingThreshold(dBodyID body, dReal threshold);
ODE_API dReal dBodyGetAngularDampingThreshold(dBodyID body);
ODE_API void dBodySetMaxAngularSpeed(dBodyID body, dReal max_speed);
ODE_API dReal dBodyGetMaxAngularSpeed(dBodyID body);

/* ======================================================================== joints, all types

   A joint is made in a world, alone (group 0) or in a group, then attached, then given its anchor
   and axes, which are world coordinates at that moment and stick to the bodies from then on.
   Setting an anchor or axis also makes the current relative pose the zero of angles and
   positions. On a joint with no body, setters of anchors and axes do nothing. Axes need not be unit
   vectors; a zero axis is refused. Typed functions refuse joints of another type. */

ODE_API dJointID dJointCreateBall(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateHinge(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateSlider(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateHinge2(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateUniversal(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateFixed(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateAMotor(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateLMotor(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreatePlane2D(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreatePR(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreatePU(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreatePiston(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateDBall(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateDHinge(dWorldID world, dJointGroupID group);
ODE_API dJointID dJointCreateTransmission(dWorldID world, dJointGroupID group);

/** A joint that only connects: it has no constraint but joins islands and counts in
    dAreConnected. */
ODE_API dJointID dJointCreateNull(dWorldID world, dJointGroupID group);

/** A contact. *contact is copied; geom.g1 and geom.g2 do not choose the bodies, dJointAttach does.
    Meant to live for one step: put it in a group and empty the group after the step. */
ODE_API dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact* contact);

/** Destroy a joint. A joint in a group is left alone: it goes with its group. */
ODE_API void dJointDestroy(dJointID joint);

/** A set of joints that are destroyed together, cheaply. max_size is not used; give 0. */
ODE_API dJointGroupID dJointGroupCreate(int max_size);

/** Destroy a group with its joints; or only its joints, the group staying usable. */
ODE_API void dJointGroupDestroy(dJointGroupID group);
ODE_API void dJointGroupEmpty(dJointGroupID group);

/** Attach to two bodies, or to one body and the world (the other being 0); (0, 0) detaches. The bodies must
    be different and of the joint's world; hinge-2 and transmission need both. (0, body) is allowed: the joint
   then counts the world as its first body, and angles and positions change sign accordingly. Attaching anew
   keeps the anchor and axes in the new first body's frame. */
ODE_API void dJointAttach(dJointID joint, dBodyID body1, dBodyID body2);

/** How many bodies are attached (0, 1, 2), and which: index 0 or 1 as in dJointAttach, 0 when there
    is none or for another index. */
ODE_API int dJointGetNumBodies(dJointID joint);
ODE_API dBodyID dJointGetBody(dJointID joint, int index);

/** A disabled joint exerts no force and connects no island, but stays attached. Default: enabled. */
ODE_API void dJointEnable(dJointID joint);
ODE_API void dJointDisable(dJointID joint);
ODE_API int dJointIsEnabled(dJointID joint);

/** A pointer of the program's, NULL at first. */
ODE_API void dJointSetData(dJointID joint, void* data);
ODE_API void* dJointGetData(dJointID joint);

ODE_API dJointType dJointGetType(dJointID joint);

/** Where each step writes the joint's forces (common.h); the struct belongs to the program and must
    outlive its use. NULL (default): nowhere. With one body attached only f1 and t1 are written.
    Motor forces applied while at a stop, and the dJointAdd... functions, are not included. */
ODE_API void dJointSetFeedback(dJointID joint, dJointFeedback* feedback);
ODE_API dJointFeedback* dJointGetFeedback(dJointID joint);

/** A joint between the two bodies, most recently attached first, or 0. One of the bodies may be 0:
    the world. The list form writes all of them to the caller's array (as many as
    dBodyGetNumJoints says are enough) and returns how many. */
ODE_API dJointID dConnectingJoint(dBodyID body1, dBodyID body2);
ODE_API int dConnectingJointList(dBodyID body1, dBodyID body2, dJointID* list);

/** 1 when a joint connects the two bodies directly, else 0. body1 must not be 0, body2 may be. The second
   form does not count joints of the given type (usually dJointTypeContact). */
ODE_API int dAreConnected(dBodyID body1, dBodyID body2);
ODE_API int dAreConnectedExcluding(dBodyID body1, dBodyID body2, int joint_type);

#ifdef __cplusplus
}
#endif

#include <ode/objects_joints.h>

#endif
