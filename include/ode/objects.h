/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Dynamics: worlds, rigid bodies, joints of all types, and the functions that move them in time. What belongs
 * to one type of joint is in objects_joints.h, which this file includes: programs written for ODE know one.
 * Both are long, because ODE's programs include them by name and every entry documents itself.
 *
 * A step of size h solves for the joint forces lambda (N, N m) of each island of connected bodies
 *     (J M^-1 J^T + CFM/h) lambda = rhs,   lo <= lambda <= hi,   J v+ = ERP/h * error - CFM lambda,
 * then moves velocities and positions on by h (velocities first: semi-implicit Euler). ERP is the
 * part of a joint's position error that is corrected per step, CFM its softness. A spring of stiffness
 * kp with damping kd is ERP = h kp / (h kp + kd), CFM = 1 / (h kp + kd).
 *
 * Unless said otherwise: positions, vectors and forces are in the world frame and in SI units,
 * angles in radians; NaN and infinities are refused where a finite number is meant; a call on a null
 * or wrong object is refused (error.h); getters that fill a vector write 3 components. */
#ifndef _ODE_OBJECTS_H_
#define _ODE_OBJECTS_H_

#include <ode/common.h>
#include <ode/contact.h>
#include <ode/mass.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter worlds Worlds

    A world holds bodies and joints and moves them on in time. Worlds know nothing of each other and may
    be stepped by different threads at the same time.

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; numbers that are not finite; a null pointer to what is to be
    written. Nothing changes then, and getters answer 0. */

/** A new, empty world with no gravity. [guide] */
ODE_API dWorldID dWorldCreate(void);

/** Destroy a world with all its bodies and all its joints that are in no joint group. Geoms survive
    without a body. Joints in groups lose their world and bodies (a message is sent for each) and go with
    their group. [guide] */
ODE_API void dWorldDestroy(dWorldID world);

/** - dWorldSetData: Store a pointer of the program's, data, with the world; NULL at first. The library never
      looks at it.
    - dWorldGetData: The pointer that the program stored with dWorldSetData; NULL if it stored none. [0.16] */
ODE_API void dWorldSetData(dWorldID world, void* data);
ODE_API void* dWorldGetData(dWorldID world);

/** - dWorldSetGravity: Set gravity to (x, y, z), m/s^2, world frame; default (0, 0, 0). It acts on every
      body whose gravity mode is on.
    - dWorldGetGravity: Write the world's gravity, m/s^2, to gravity: 3 reals, world frame. [guide] */
ODE_API void dWorldSetGravity(dWorldID world, dReal x, dReal y, dReal z);
ODE_API void dWorldGetGravity(dWorldID world, dVector3 gravity);

/** - dWorldSetERP: Set the world's error reduction parameter erp: the part of joint errors that is corrected
      per step, sensibly 0.1 ... 0.8, default 0.2. Joints use the current value, except those parameters that
      a joint copies when it is created (dParamERP, dParamStopERP, dParamSuspensionERP).
    - dWorldGetERP: The world's error reduction parameter, 0.2 at first. [guide] */
ODE_API void dWorldSetERP(dWorldID world, dReal erp);
ODE_API dReal dWorldGetERP(dWorldID world);

/** - dWorldSetCFM: Set the world's constraint force mixing cfm: the softness of joints, sensibly 1e-9 ... 1,
      default 1e-10 (1e-5 in single precision). Joints use the current value, except those parameters that a
      joint copies when it is created (dParamCFM, dParamStopCFM, dParamSuspensionCFM). The default has a limit
      under heavy bodies (docs/guide/softness.md); other numbers are literal. A negative one is refused.
    - dWorldGetCFM: The world's constraint force mixing; at first 1e-10, 1e-5 in single precision. [guide] */
ODE_API void dWorldSetCFM(dWorldID world, dReal cfm);
ODE_API dReal dWorldGetCFM(dWorldID world);

/** Who does the work of a world's steps: a threading implementation of the library (ode/threading_impl.h) or
    of the program, given by its table functions_info (which is copied) and its handle threading_impl.
    Islands, and parts of large islands, become calls of it, as many at a time as it has threads (at most 64),
    at least one; the thread that steps waits for them. A step has the same bits as without. Both NULL, the
    default: the calling thread, or those of dWorldSetStepThreads (ode/ext.h), which does not count while an
    implementation is set. One implementation may serve several worlds, also at the same time. Refused: one of
    the two NULL, struct_size too small or a function missing, during a step. When the implementation cannot
    prepare for a step (its preallocation or its wait fails) the step returns 0 and the world stays as it was.
    [0.16] */
ODE_API void dWorldSetStepThreadingImplementation(dWorldID world,
                                                  const dThreadingFunctionsInfo* functions_info,
                                                  dThreadingImplementationID threading_impl);

/** - dWorldSetStepIslandsProcessingMaxThreadCount: Set the most threads (count) that work on a step; 0 (the
      default, dWORLDSTEP_THREADCOUNT_UNLIMITED) sets no limit. It is a limit only: a world that has been
      given no threads steps on the calling thread.
    - dWorldGetStepIslandsProcessingMaxThreadCount: The most threads that work on a step; 0: no limit. [0.16]
 */
#define dWORLDSTEP_THREADCOUNT_UNLIMITED dTHREADING_THREAD_COUNT_UNLIMITED
ODE_API void dWorldSetStepIslandsProcessingMaxThreadCount(dWorldID world, unsigned count);
ODE_API unsigned dWorldGetStepIslandsProcessingMaxThreadCount(dWorldID world);

/** @chapter step_memory Working memory of steps

    A step takes its scratch memory in blocks that stay with the world: after the largest step of a scene no
    more are asked for. The memory is made by the first step, or by the functions below, and has settings of
    its own. Without them it comes from dAlloc.

    Refused: a world that is 0 or destroyed; a call during a step. Nothing changes then, and the answer is
    0. */

/** Let the world use the working memory of from_world, and its settings, from now on (it is made if
    from_world has none); it is given back with the last world that uses it. The worlds must not step at the
    same time: a step that would is refused. A world that has working memory already is refused; from_world
    NULL takes it away first: the world's next step begins with memory and settings as in a new world. Returns
    1, or 0 when refused or out of memory. [0.16] */
ODE_API int dWorldUseSharedWorkingMemory(dWorldID world, dWorldID from_world);

/** Give the blocks back at once, with what the world keeps to save time; settings stay, and no result
    changes. Concerns all worlds that share the memory. [0.16] */
ODE_API void dWorldCleanupWorkingMemory(dWorldID world);

/** What dWorldStepReserveInfo holds at first. */
#define dWORLDSTEP_RESERVEFACTOR_DEFAULT 1.2f
#define dWORLDSTEP_RESERVESIZE_DEFAULT 65536U

/** How much is taken in reserve. When blocks have become too small, they are replaced by one of
    reserve_factor times what the largest step needed; no block is smaller than reserve_minimum. struct_size:
    sizeof of the struct, set by the caller. */
typedef struct {
    unsigned struct_size;     /**< sizeof(dWorldStepReserveInfo) */
    float reserve_factor;     /**< how many times what is needed, at least 1 */
    unsigned reserve_minimum; /**< bytes */
} dWorldStepReserveInfo;

/** Set the reserve for blocks taken from now on, to a copy of *policyinfo; NULL: back to the defaults.
    Returns 1, or 0 when refused (a factor below 1 or not finite, struct_size too small) or out of memory.
    [0.16] */
ODE_API int dWorldSetStepMemoryReservationPolicy(dWorldID world, const dWorldStepReserveInfo* policyinfo);

/** Where step memory comes from. The functions are called by one thread at a time, which with several threads
    need not be the one that steps. They must not change the joints of the world that is stepped, which is in
    a step as in a moved callback. struct_size: sizeof of the struct, set by the caller. */
typedef struct {
    unsigned struct_size; /**< sizeof(dWorldStepMemoryFunctionsInfo) */
    /** gives a block of block_size bytes aligned for any type, or NULL, with which the step returns 0 */
    void* (*alloc_block)(dsizeint block_size);
    /** for programs that have one: the library does not shrink, and it may be NULL */
    void* (*shrink_block)(void* block_pointer, dsizeint block_current_size, dsizeint block_smaller_size);
    /** takes a block back, with the size that it was asked with */
    void (*free_block)(void* block_pointer, dsizeint block_current_size);
} dWorldStepMemoryFunctionsInfo;

/** Take blocks from a copy of *memfuncs from now on; NULL: from dAlloc again. Blocks that are there already
    go back where they came from. Returns 1, or 0 when refused (alloc_block or free_block NULL, struct_size too
    small) or out of memory. [0.16] */
ODE_API int dWorldSetStepMemoryManager(dWorldID world, const dWorldStepMemoryFunctionsInfo* memfuncs);

/** @chapter stepping Stepping

    Three solvers, which may be mixed freely on one world: dWorldStep solves exactly, dWorldQuickStep
    iterates, dWorldStepFast1 (compatibility.h) takes small steps.

    Refused: a world that is 0 or destroyed; [dWorldStep, dWorldQuickStep] a stepsize that is not positive
    and finite; [dWorldStep, dWorldQuickStep] a step within a step, as from a moved callback;
    [dWorldImpulse, dWorldSetQuickStepW] numbers that are not finite. Nothing changes then, and the answer
    is 0. */

/** Advance by stepsize seconds with the exact solver: the mixed complementarity problem of each island is
    solved to rounding. Friction limits are taken from the normal forces of the frictionless solution.
    Time grows with the cube, memory with the square of the constraint rows in an island. Order:
    auto-disable test; islands; per island forces, rows, solution, new velocities, new positions, moved
    callbacks. Force and torque accumulators of stepped bodies are zero afterwards. Returns 1; 0 when
    refused (stepsize not positive and finite) or out of memory: poses, velocities and accumulators are
    then as they were. [guide] */
ODE_API int dWorldStep(dWorldID world, dReal stepsize);

/** Advance by stepsize seconds with the iterative solver (projected successive over-relaxation): time and
    memory linear in the rows. Friction limits follow the normal forces during the iteration. All else as
    dWorldStep. [0.16] */
ODE_API int dWorldQuickStep(dWorldID world, dReal stepsize);

/** The constant force (N, 3 reals written) that gives the impulse (ix, iy, iz), N s, within one step of
    stepsize seconds, which must not be 0: impulse / stepsize. [0.16] */
ODE_API void dWorldImpulseToForce(dWorldID world, dReal stepsize, dReal ix, dReal iy, dReal iz,
                                  dVector3 force);

/** - dWorldSetQuickStepNumIterations: Set how many iterations (num) dWorldQuickStep makes, default 20. 0 or
      less lets the joints exert no force. More than 100000 are refused.
    - dWorldGetQuickStepNumIterations: How many iterations dWorldQuickStep makes, 20 at first. [0.16] */
ODE_API void dWorldSetQuickStepNumIterations(dWorldID world, int num);
ODE_API int dWorldGetQuickStepNumIterations(dWorldID world);

/** - dWorldSetQuickStepW: Set the factor over_relaxation of dWorldQuickStep, sensibly within (0, 2), default
      1.3.
    - dWorldGetQuickStepW: The factor of over-relaxation of dWorldQuickStep, 1.3 at first. [0.16] */
ODE_API void dWorldSetQuickStepW(dWorldID world, dReal over_relaxation);
ODE_API dReal dWorldGetQuickStepW(dWorldID world);

/** @chapter world_contacts Contacts of a world

    Settings for all contact joints of a world.

    Refused: a world that is 0 or destroyed; [dWorldSetContactSurfaceLayer] a depth that is not finite;
    [dWorldSetContactMaxCorrectingVel] NaN. Nothing changes then, and getters answer 0. */

/** - dWorldSetContactMaxCorrectingVel: Set the greatest velocity vel, m/s, that a contact may use to undo
      penetration, and, if finite, to move joints back from beyond stops; default dInfinity. Bouncing is free. If
      it is finite, a step that would throw an island by closing joints or contacts makes a share of that.
    - dWorldGetContactMaxCorrectingVel: The greatest velocity that a contact may use to undo penetration,
      m/s; dInfinity at first. [0.16] */
ODE_API void dWorldSetContactMaxCorrectingVel(dWorldID world, dReal vel);
ODE_API dReal dWorldGetContactMaxCorrectingVel(dWorldID world);

/** - dWorldSetContactSurfaceLayer: Set the depth of penetration, m, that contacts leave alone so that they
      persist; default 0.
    - dWorldGetContactSurfaceLayer: The depth of penetration that contacts leave alone, m; 0 at first. [0.16]
 */
ODE_API void dWorldSetContactSurfaceLayer(dWorldID world, dReal depth);
ODE_API dReal dWorldGetContactSurfaceLayer(dWorldID world);

/** @chapter auto_disable Automatic disabling: the values for bodies made later

    A body with the flag on, at least one joint or contact, and average linear and angular speed at or below
    the thresholds is idle. In an island with contacts it is also idle if it has moved by at most the linear
    threshold times T, and turned by at most five times the angular one times T, over the last T = 0.5 s or
    4 s. When all bodies of an island have been idle for `steps` steps and `time` seconds they are disabled
    and their velocities set to zero; nine in ten suffice if the others have stayed near their places for a
    second. A body wakes when an enabled one reaches it through a joint or contact, and in a world that
    manages its contacts when its support changes (docs/guide/sleeping.md).

    Refused: a world that is 0 or destroyed; [dWorldSet*Threshold, dWorldSet*Time] NaN. Nothing changes
    then, and getters answer 0. */

/** - dWorldSetAutoDisableLinearThreshold: Set the linear speed linear_average_threshold, m/s, up to which
      new bodies count as idle; default 0.01.
    - dWorldGetAutoDisableLinearThreshold: The linear speed up to which new bodies count as idle, m/s; 0.01
      at first. [0.16] */
ODE_API void dWorldSetAutoDisableLinearThreshold(dWorldID world, dReal linear_average_threshold);
ODE_API dReal dWorldGetAutoDisableLinearThreshold(dWorldID world);

/** - dWorldSetAutoDisableAngularThreshold: Set the angular speed angular_average_threshold, rad/s, up to
      which new bodies count as idle; default 0.01.
    - dWorldGetAutoDisableAngularThreshold: The angular speed up to which new bodies count as idle, rad/s;
      0.01 at first. [0.16] */
ODE_API void dWorldSetAutoDisableAngularThreshold(dWorldID world, dReal angular_average_threshold);
ODE_API dReal dWorldGetAutoDisableAngularThreshold(dWorldID world);

/** - dWorldSetAutoDisableAverageSamplesCount: Set over how many steps (average_samples_count) the velocities
      of new bodies are averaged, as vectors, so that swinging cancels. Default 1: the current velocity; 0:
      never disable. More than 2^20 are refused.
    - dWorldGetAutoDisableAverageSamplesCount: Over how many steps the velocities of new bodies are averaged,
      1 at first. [0.16] */
ODE_API void dWorldSetAutoDisableAverageSamplesCount(dWorldID world, unsigned int average_samples_count);
ODE_API int dWorldGetAutoDisableAverageSamplesCount(dWorldID world);

/** - dWorldSetAutoDisableSteps: Set how many idle steps new bodies need before they are disabled; default
      10.
    - dWorldGetAutoDisableSteps: How many idle steps new bodies need before they are disabled, 10 at first.
      [0.16] */
ODE_API void dWorldSetAutoDisableSteps(dWorldID world, int steps);
ODE_API int dWorldGetAutoDisableSteps(dWorldID world);

/** - dWorldSetAutoDisableTime: Set how much idle time, s, new bodies need before they are disabled; default
      0.
    - dWorldGetAutoDisableTime: How much idle time new bodies need before they are disabled, s; 0 at first.
      [0.16] */
ODE_API void dWorldSetAutoDisableTime(dWorldID world, dReal time);
ODE_API dReal dWorldGetAutoDisableTime(dWorldID world);

/** - dWorldSetAutoDisableFlag: Set whether new bodies disable themselves (do_auto_disable not 0); default 0.
    - dWorldGetAutoDisableFlag: Non-zero if new bodies disable themselves, else 0. [0.16] */
ODE_API void dWorldSetAutoDisableFlag(dWorldID world, int do_auto_disable);
ODE_API int dWorldGetAutoDisableFlag(dWorldID world);

/** @chapter damping Damping and speed limit: the values for bodies made later

    After each step a speed above its threshold is multiplied by (1 - scale), whatever the step size.

    Refused: a world that is 0 or destroyed; [dWorldSet*Damping, !dWorldSet*DampingThreshold] numbers that are
    not finite; [dWorldSet*DampingThreshold, dWorldSetMaxAngularSpeed] NaN. Nothing changes then, and getters
    answer 0. */

/** - dWorldSetLinearDampingThreshold: Set the linear speed threshold, m/s, from which on damping acts on new
    bodies; default 0.01.
    - dWorldGetLinearDampingThreshold: The linear speed from which on damping acts on new bodies, m/s; 0.01
      at first.
    - dWorldSetAngularDampingThreshold: Set the angular speed threshold, rad/s, from which on damping acts on
    new bodies; default 0.01.
    - dWorldGetAngularDampingThreshold: The angular speed from which on damping acts on new bodies, rad/s;
      0.01 at first. [0.16] */
ODE_API void dWorldSetLinearDampingThreshold(dWorldID world, dReal threshold);
ODE_API dReal dWorldGetLinearDampingThreshold(dWorldID world);
ODE_API void dWorldSetAngularDampingThreshold(dWorldID world, dReal threshold);
ODE_API dReal dWorldGetAngularDampingThreshold(dWorldID world);

/** - dWorldSetLinearDamping: Set the scale of linear damping of new bodies, sensibly 0 ... 1; default 0, no
      damping.
    - dWorldGetLinearDamping: The scale of linear damping of new bodies, 0 at first.
    - dWorldSetAngularDamping: Set the scale of angular damping of new bodies, sensibly 0 ... 1; default 0,
      no damping.
    - dWorldGetAngularDamping: The scale of angular damping of new bodies, 0 at first.
    - dWorldSetDamping: Set the scales of linear (linear_scale) and angular damping (angular_scale) of new
      bodies, each sensibly 0 ... 1; default 0, no damping. [0.16] */
ODE_API void dWorldSetLinearDamping(dWorldID world, dReal scale);
ODE_API dReal dWorldGetLinearDamping(dWorldID world);
ODE_API void dWorldSetAngularDamping(dWorldID world, dReal scale);
ODE_API dReal dWorldGetAngularDamping(dWorldID world);
ODE_API void dWorldSetDamping(dWorldID world, dReal linear_scale, dReal angular_scale);

/** - dWorldSetMaxAngularSpeed: Set the angular speed max_speed, rad/s, that new bodies are held to; default
      dInfinity.
    - dWorldGetMaxAngularSpeed: The angular speed that new bodies are held to, rad/s; dInfinity at first.
      [0.16] */
ODE_API void dWorldSetMaxAngularSpeed(dWorldID world, dReal max_speed);
ODE_API dReal dWorldGetMaxAngularSpeed(dWorldID world);

/** @chapter bodies Rigid bodies

    A body has a position (its centre of mass), an orientation, velocities, a mass, and forces that act in
    the next step. It has no shape: geoms give it one (collision.h).

    Arguments:
    - body: the body.
    - x, y, z: the components of a vector, world frame.
    - px, py, pz: a point, m, in the frame that the text names.
    - result: where 3 reals are written.

    Refused: a body that is 0 or destroyed; numbers that are not finite; a null pointer to what is to be
    read or written. Nothing changes then, and getters answer 0. */

/** A new body in the world: at the origin, not rotated, at rest, mass 1 kg with unit inertia, enabled;
    gravity and gyroscopic mode on; auto-disable, damping and speed limit as the world has them now.
    [0.16] */
ODE_API dBodyID dBodyCreate(dWorldID world);

/** Destroy a body. Its geoms stay where they are, without a body. Its joints stay, detached from both of
    their bodies. [0.16] */
ODE_API void dBodyDestroy(dBodyID body);

/** The world that the body is in. [0.16] */
ODE_API dWorldID dBodyGetWorld(dBodyID body);

/** - dBodySetData: Store a pointer of the program's, data, with the body; NULL at first. The library never
      looks at it.
    - dBodyGetData: The pointer that the program stored with dBodySetData; NULL if it stored none. [guide] */
ODE_API void dBodySetData(dBodyID body, void* data);
ODE_API void* dBodyGetData(dBodyID body);

/** @chapter body_state Bodies: pose and velocity

    Setters move the body at once, with its geoms; they do not wake it and call no callback (a velocity wakes
    a kinematic body of a world that manages its contacts). After a jump joints have errors, which the
    following steps correct.

    Refused: as for bodies; [dBodySet] moving a body whose geoms are in a space that is being collided. */

/** Position of the body's origin, which is its centre of mass, m. [guide] */
ODE_API void dBodySetPosition(dBodyID body, dReal x, dReal y, dReal z);

/** - dBodySetRotation: Set the body's orientation, from body to world, by the rotation matrix R (12 reals,
      made orthonormal here). A degenerate matrix is refused.
    - dBodySetQuaternion: Set the body's orientation, from body to world, by the quaternion q (4 reals,
      normalised here). A zero quaternion is refused. [guide] */
ODE_API void dBodySetRotation(dBodyID body, const dMatrix3 R);
ODE_API void dBodySetQuaternion(dBodyID body, const dQuaternion q);

/** - dBodySetLinearVel: Set the velocity of the body's centre of mass to (x, y, z), m/s.
    - dBodySetAngularVel: Set the body's angular velocity to (x, y, z), rad/s. [guide] */
ODE_API void dBodySetLinearVel(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodySetAngularVel(dBodyID body, dReal x, dReal y, dReal z);

/** The pointer stays valid as long as the body, and shows its current state.
    - dBodyGetPosition: A pointer to the body's position, 3 reals, m.
    - dBodyGetRotation: A pointer to the body's rotation matrix, from body to world, 12 reals.
    - dBodyGetQuaternion: A pointer to the body's orientation as a quaternion, from body to world, 4 reals.
    - dBodyGetLinearVel: A pointer to the velocity of the body's centre of mass, 3 reals, m/s.
    - dBodyGetAngularVel: A pointer to the body's angular velocity, 3 reals, rad/s. [guide] */
ODE_API const dReal* dBodyGetPosition(dBodyID body);
ODE_API const dReal* dBodyGetRotation(dBodyID body);
ODE_API const dReal* dBodyGetQuaternion(dBodyID body);
ODE_API const dReal* dBodyGetLinearVel(dBodyID body);
ODE_API const dReal* dBodyGetAngularVel(dBodyID body);

/** - dBodyCopyPosition: Copy the body's position, m, to pos: 3 reals.
    - dBodyCopyRotation: Copy the body's rotation matrix, from body to world, to R: 12 reals.
    - dBodyCopyQuaternion: Copy the body's orientation, from body to world, to the quaternion quat: 4 reals.
      [0.16] */
ODE_API void dBodyCopyPosition(dBodyID body, dVector3 pos);
ODE_API void dBodyCopyRotation(dBodyID body, dMatrix3 R);
ODE_API void dBodyCopyQuaternion(dBodyID body, dQuaternion quat);

/** @chapter body_forces Bodies: mass and forces

    Refused: as for bodies. */

/** - dBodySetMass: Give the body a copy of *mass; it becomes dynamic. Refused if the centre of mass is not
      at the origin or dMassCheck says no.
    - dBodyGetMass: Write the body's mass to *mass. A kinematic body has one in store. [guide] */
ODE_API void dBodySetMass(dBodyID body, const dMass* mass);
ODE_API void dBodyGetMass(dBodyID body, dMass* mass);

/** It acts during the whole next step and is zeroed after it, as are all others that have been added.
    - dBodyAddForce: Add the force (fx, fy, fz), N, world frame, at the body's centre of mass.
    - dBodyAddTorque: Add the torque (fx, fy, fz), N m, world frame.
    - dBodyAddRelForce: Add the force (fx, fy, fz), N, in the body's axes, at the body's centre of mass.
    - dBodyAddRelTorque: Add the torque (fx, fy, fz), N m, in the body's axes.
    - dBodyAddForceAtPos: Add the force (fx, fy, fz), N, world frame, at the world's point (px, py, pz), with
      its torque about the centre of mass.
    - dBodyAddForceAtRelPos: Add the force (fx, fy, fz), N, world frame, at the point (px, py, pz) of the
      body's frame, with its torque about the centre of mass.
    - dBodyAddRelForceAtPos: Add the force (fx, fy, fz), N, in the body's axes, at the world's point (px, py,
      pz), with its torque about the centre of mass.
    - dBodyAddRelForceAtRelPos: Add the force (fx, fy, fz), N, in the body's axes, at the point (px, py, pz)
      of the body's frame, with its torque about the centre of mass. [guide] */
ODE_API void dBodyAddForce(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddTorque(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddRelForce(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddRelTorque(dBodyID body, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddForceAtPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddForceAtRelPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForceAtPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForceAtRelPos(dBodyID body, dReal fx, dReal fy, dReal fz, dReal px, dReal py,
                                      dReal pz);

/** A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    - dBodyGetForce: A pointer to the sum of the forces that have been added for the next step: 3 reals, N,
      world frame.
    - dBodyGetTorque: A pointer to the sum of the torques that have been added for the next step: 3 reals, N
      m, world frame.
    - dBodySetForce: Set the sum of the forces for the next step to (x, y, z), N, world frame.
    - dBodySetTorque: Set the sum of the torques for the next step to (x, y, z), N m, world frame. [guide] */
ODE_API const dReal* dBodyGetForce(dBodyID body);
ODE_API const dReal* dBodyGetTorque(dBodyID body);
ODE_API void dBodySetForce(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodySetTorque(dBodyID body, dReal x, dReal y, dReal z);

/** @chapter body_points Bodies: points and directions

    Refused: as for bodies. */

/** - dBodyGetRelPointPos: The position in the world, m, of the point (px, py, pz) of the body's frame.
    - dBodyGetRelPointVel: The velocity in the world, m/s, of the point (px, py, pz) of the body's frame.
      [guide] */
ODE_API void dBodyGetRelPointPos(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dBodyGetRelPointVel(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** Velocity of the body's material at the world point (px, py, pz), m/s, world frame. [guide] */
ODE_API void dBodyGetPointVel(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** Body coordinates of the world point (px, py, pz). [guide] */
ODE_API void dBodyGetPosRelPoint(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** - dBodyVectorToWorld: The direction (px, py, pz) of the body's frame, turned to the world's axes.
    - dBodyVectorFromWorld: The direction (px, py, pz) of the world, turned to the body's axes. [guide] */
ODE_API void dBodyVectorToWorld(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dBodyVectorFromWorld(dBodyID body, dReal px, dReal py, dReal pz, dVector3 result);

/** @chapter body_modes Bodies: how a body moves

    Refused: as for bodies. */

/** - dBodySetFiniteRotationMode: Set how the body's orientation is advanced (mode). 0 (default): q += h/2
      (0, w) q, normalised; cheap, inexact at high spin. Non-zero: the exact rotation by |w| h; with a finite
      rotation axis only the part of w about that axis is treated exactly.
    - dBodyGetFiniteRotationMode: Non-zero if the body's orientation is advanced by exact rotations, else 0,
      the default. [guide, 0.16] */
ODE_API void dBodySetFiniteRotationMode(dBodyID body, int mode);
ODE_API int dBodyGetFiniteRotationMode(dBodyID body);

/** - dBodySetFiniteRotationAxis: Set the axis of fast spin to (x, y, z), world frame, normalised here; (0,
      0, 0), the default, means none.
    - dBodyGetFiniteRotationAxis: Write the axis of fast spin, a unit vector in the world's frame, to result;
      zeros: none. [guide, 0.16] */
ODE_API void dBodySetFiniteRotationAxis(dBodyID body, dReal x, dReal y, dReal z);
ODE_API void dBodyGetFiniteRotationAxis(dBodyID body, dVector3 result);

/** - dBodyGetNumJoints: How many joints are attached to the body.
    - dBodyGetJoint: The joint number index of those attached to the body, 0 being the one attached most
      recently; 0 for an index that there is not. [guide] */
ODE_API int dBodyGetNumJoints(dBodyID body);
ODE_API dJointID dBodyGetJoint(dBodyID body, int index);

/** A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    on others as if infinitely heavy.
    - dBodySetDynamic: Make the body dynamic, which is the default, with the mass that it had.
    - dBodySetKinematic: Make the body kinematic; it keeps its mass in store.
    - dBodyIsKinematic: 1 if the body is kinematic, else 0. [0.16] */
ODE_API void dBodySetDynamic(dBodyID body);
ODE_API void dBodySetKinematic(dBodyID body);
ODE_API int dBodyIsKinematic(dBodyID body);

/** A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    keeps its velocity.
    - dBodyEnable: Wake the body and restart its idle counters. New bodies are enabled.
    - dBodyDisable: Put the body to sleep.
    - dBodyIsEnabled: 1 if the body is enabled, 0 if it is disabled. [guide] */
ODE_API void dBodyEnable(dBodyID body);
ODE_API void dBodyDisable(dBodyID body);
ODE_API int dBodyIsEnabled(dBodyID body);

/** - dBodySetGravityMode: Set whether the world's gravity acts on the body (mode not 0); default 1.
    - dBodyGetGravityMode: Non-zero if the world's gravity acts on the body, else 0. [guide] */
ODE_API void dBodySetGravityMode(dBodyID body, int mode);
ODE_API int dBodyGetGravityMode(dBodyID body);

/** - dBodySetGyroscopicMode: Set whether the gyroscopic torque -w x I w is applied to the body (enabled not
      0), by an implicit formula that is stable at any spin; default on.
    - dBodyGetGyroscopicMode: Non-zero if the gyroscopic torque is applied to the body, else 0. [0.16] */
ODE_API void dBodySetGyroscopicMode(dBodyID body, int enabled);
ODE_API int dBodyGetGyroscopicMode(dBodyID body);

/** A function (callback) that is called with every body that a step moved, after its new pose is set and
    before damping. It must not destroy the body or change the world's structure. NULL (default): none.
    [0.16] */
ODE_API void dBodySetMovedCallback(dBodyID body, void (*callback)(dBodyID));

/** - dBodyGetFirstGeom: The geom that was put on the body most recently, or 0.
    - dBodyGetNextGeom: The geom of the same body that was put on it just before geom, or 0. [0.16] */
ODE_API dGeomID dBodyGetFirstGeom(dBodyID body);
ODE_API dGeomID dBodyGetNextGeom(dGeomID geom);

/** @chapter body_auto_disable Bodies: automatic disabling of one body

    What the settings mean stands with the world's functions. New bodies take theirs over from the world.

    Refused: a body that is 0 or destroyed; [dBodySet*Threshold, dBodySet*Time] NaN. Nothing changes then,
    and getters answer 0. */

/** - dBodySetAutoDisableLinearThreshold: Set the averaged linear speed linear_average_threshold, m/s, up to
      which the body counts as idle.
    - dBodyGetAutoDisableLinearThreshold: The averaged linear speed up to which the body counts as idle, m/s.
    - dBodySetAutoDisableAngularThreshold: Set the averaged angular speed angular_average_threshold, rad/s,
      up to which the body counts as idle.
    - dBodyGetAutoDisableAngularThreshold: The averaged angular speed up to which the body counts as idle,
      rad/s. [0.16] */
ODE_API void dBodySetAutoDisableLinearThreshold(dBodyID body, dReal linear_average_threshold);
ODE_API dReal dBodyGetAutoDisableLinearThreshold(dBodyID body);
ODE_API void dBodySetAutoDisableAngularThreshold(dBodyID body, dReal angular_average_threshold);
ODE_API dReal dBodyGetAutoDisableAngularThreshold(dBodyID body);

/** - dBodySetAutoDisableAverageSamplesCount: Set over how many steps (average_samples_count) the body's
      velocities are averaged; more than 2^20 are refused. Changing the count throws the samples gathered so
      far away.
    - dBodyGetAutoDisableAverageSamplesCount: Over how many steps the body's velocities are averaged. [0.16]
 */
ODE_API void dBodySetAutoDisableAverageSamplesCount(dBodyID body, unsigned int average_samples_count);
ODE_API int dBodyGetAutoDisableAverageSamplesCount(dBodyID body);

/** - dBodySetAutoDisableSteps: Set how many idle steps the body needs before it is disabled. The new value
      counts from the next restart of the idle counters.
    - dBodyGetAutoDisableSteps: How many idle steps the body needs before it is disabled.
    - dBodySetAutoDisableTime: Set how much idle time, s, the body needs before it is disabled. The new value
      counts from the next restart of the idle counters.
    - dBodyGetAutoDisableTime: How much idle time the body needs before it is disabled, s. [0.16] */
ODE_API void dBodySetAutoDisableSteps(dBodyID body, int steps);
ODE_API int dBodyGetAutoDisableSteps(dBodyID body);
ODE_API void dBodySetAutoDisableTime(dBodyID body, dReal time);
ODE_API dReal dBodyGetAutoDisableTime(dBodyID body);

/** - dBodySetAutoDisableFlag: Switch automatic disabling of the body on (do_auto_disable not 0) or off. Off
      also enables the body and takes steps, time and sample count over from the world.
    - dBodyGetAutoDisableFlag: Non-zero if the body disables itself, else 0. [0.16] */
ODE_API void dBodySetAutoDisableFlag(dBodyID body, int do_auto_disable);
ODE_API int dBodyGetAutoDisableFlag(dBodyID body);

/** Take all auto-disable settings over from the world. [0.16] */
ODE_API void dBodySetAutoDisableDefaults(dBodyID body);

/** @chapter body_damping Bodies: damping and speed limit of one body

    What the settings mean stands with the world's functions. New bodies take theirs over from the world.

    Refused: a body that is 0 or destroyed; [dBodySet*Damping, !dBodySet*DampingThreshold,
    !dBodySetDampingDefaults] numbers that are not finite; [dBodySet*DampingThreshold, dBodySetMaxAngularSpeed]
    NaN. Nothing changes then, and getters answer 0. */

/** Take all damping settings over from the world. [0.16] */
ODE_API void dBodySetDampingDefaults(dBodyID body);

/** - dBodySetLinearDamping: Set the scale of the body's linear damping, sensibly 0 ... 1; 0: no damping.
    - dBodyGetLinearDamping: The scale of the body's linear damping.
    - dBodySetAngularDamping: Set the scale of the body's angular damping, sensibly 0 ... 1; 0: no damping.
    - dBodyGetAngularDamping: The scale of the body's angular damping.
    - dBodySetDamping: Set the scales of the body's linear (linear_scale) and angular damping
      (angular_scale), each sensibly 0 ... 1; 0: no damping. [0.16] */
ODE_API void dBodySetLinearDamping(dBodyID body, dReal scale);
ODE_API dReal dBodyGetLinearDamping(dBodyID body);
ODE_API void dBodySetAngularDamping(dBodyID body, dReal scale);
ODE_API dReal dBodyGetAngularDamping(dBodyID body);
ODE_API void dBodySetDamping(dBodyID body, dReal linear_scale, dReal angular_scale);

/** - dBodySetLinearDampingThreshold: Set the linear speed threshold, m/s, from which on damping acts on the
    body.
    - dBodyGetLinearDampingThreshold: The linear speed from which on damping acts on the body, m/s.
    - dBodySetAngularDampingThreshold: Set the angular speed threshold, rad/s, from which on damping acts on
    the body.
    - dBodyGetAngularDampingThreshold: The angular speed from which on damping acts on the body, rad/s.
      [0.16] */
ODE_API void dBodySetLinearDampingThreshold(dBodyID body, dReal threshold);
ODE_API dReal dBodyGetLinearDampingThreshold(dBodyID body);
ODE_API void dBodySetAngularDampingThreshold(dBodyID body, dReal threshold);
ODE_API dReal dBodyGetAngularDampingThreshold(dBodyID body);

/** - dBodySetMaxAngularSpeed: Set the angular speed max_speed, rad/s, that the body is held to.
    - dBodyGetMaxAngularSpeed: The angular speed that the body is held to, rad/s. [0.16] */
ODE_API void dBodySetMaxAngularSpeed(dBodyID body, dReal max_speed);
ODE_API dReal dBodyGetMaxAngularSpeed(dBodyID body);

/** @chapter joints Joints of all types

    A joint is made in a world, alone (group 0) or in a group, then attached, then given its anchor and
    axes, which are world coordinates at that moment and stick to the bodies from then on. Setting an
    anchor or axis also makes the current relative pose the zero of angles and positions. On a joint with
    no body, setters of anchors and axes do nothing. Axes need not be unit vectors; a zero axis is
    refused. Typed functions refuse joints of another type.

    Arguments:
    - joint: the joint.
    - group: a group of joints, or (to make a joint alone) 0.
    - body1, body2: bodies of one world; 0 stands for the world.

    Refused: a joint, group or body that is 0 (where it may not be) or destroyed; [dJointCreate] a world
    that is 0 or destroyed; [dJointAttach, dJointDestroy, dJointGroupDestroy, dJointGroupEmpty] a call
    within a step. Nothing changes then, and the answer is 0. */

/** It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    the call is refused or memory is exhausted.
    - dJointCreateBall: A new ball joint, which holds a point of each body together.
    - dJointCreateHinge: A new hinge: a common point and a common axis.
    - dJointCreateSlider: A new slider, which lets the bodies move along one axis only.
    - dJointCreateHinge2: A new hinge-2, a car wheel on its chassis.
    - dJointCreateUniversal: A new universal (cardan) joint.
    - dJointCreateFixed: A new fixed joint, which holds the bodies' relative pose.
    - dJointCreateAMotor: A new angular motor.
    - dJointCreateLMotor: A new linear motor.
    - dJointCreatePlane2D: A new plane joint, which keeps a body in the plane z = 0.
    - dJointCreatePR: A new prismatic-rotoid joint: a slide and a turn.
    - dJointCreatePU: A new prismatic-universal joint: a slide and a universal joint.
    - dJointCreatePiston: A new piston, which slides along an axis and turns about it.
    - dJointCreateDBall: A new double ball joint, which keeps the distance of two points.
    - dJointCreateDHinge: A new double hinge: a bar with parallel hinges at its ends.
    - dJointCreateTransmission: A new transmission: gears, bevel gears or wheels with a chain. [guide, 0.16]
 */
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

/** A joint in the world, in the group or alone, that only connects: it has no constraint but joins
    islands and counts in dAreConnected. [0.16] */
ODE_API dJointID dJointCreateNull(dWorldID world, dJointGroupID group);

/** A contact in the world, in the group or alone. *contact is copied; geom.g1 and geom.g2 do not choose
    the bodies, dJointAttach does. Meant to live for one step: put it in a group and empty the group after
    the step. [guide] */
ODE_API dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact* contact);

/** Destroy the joint, which leaves its bodies. A joint in a group is left alone: it goes with its group.
    [0.16] */
ODE_API void dJointDestroy(dJointID joint);

/** A set of joints that are destroyed together, cheaply. max_size is not used; give 0. [0.16] */
ODE_API dJointGroupID dJointGroupCreate(int max_size);

/** - dJointGroupDestroy: Destroy the group and all its joints.
    - dJointGroupEmpty: Destroy all joints of the group, which stays usable. [guide, 0.16] */
ODE_API void dJointGroupDestroy(dJointGroupID group);
ODE_API void dJointGroupEmpty(dJointGroupID group);

/** Attach to two bodies body1 and body2, or to one body and the world (the other being 0); (0, 0)
    detaches. The bodies must be different and of the joint's world; hinge-2 and transmission need both.
    (0, body) is allowed: the joint then counts the world as its first body, and angles and positions
    change sign accordingly. Attaching anew keeps the anchor and axes in the new first body's frame.
    [guide] */
ODE_API void dJointAttach(dJointID joint, dBodyID body1, dBodyID body2);

/** - dJointGetNumBodies: How many bodies are attached to the joint: 0, 1 or 2.
    - dJointGetBody: The body of the joint with this index, 0 or 1 as in dJointAttach; 0 if there is none, or
      for another index. [0.16] */
ODE_API int dJointGetNumBodies(dJointID joint);
ODE_API dBodyID dJointGetBody(dJointID joint, int index);

/** A disabled joint exerts no force and connects no island, but stays attached.
    - dJointEnable: Let the joint act again. New joints are enabled.
    - dJointDisable: Let the joint act no more until dJointEnable.
    - dJointIsEnabled: 1 if the joint is enabled, 0 if it is disabled. [0.16] */
ODE_API void dJointEnable(dJointID joint);
ODE_API void dJointDisable(dJointID joint);
ODE_API int dJointIsEnabled(dJointID joint);

/** - dJointSetData: Store a pointer of the program's, data, with the joint; NULL at first. The library never
      looks at it.
    - dJointGetData: The pointer that the program stored with dJointSetData; NULL if it stored none. [guide]
 */
ODE_API void dJointSetData(dJointID joint, void* data);
ODE_API void* dJointGetData(dJointID joint);

/** The joint's type; dJointTypeNone when refused. [guide] */
ODE_API dJointType dJointGetType(dJointID joint);

/** - dJointSetFeedback: Set where each step writes the joint's forces: *feedback (common.h), N and N m,
      world frame. The struct belongs to the program and must outlive its use. NULL (default): nowhere. With
      one body attached only f1 and t1 are written. Motor forces applied while at a stop, and the
      dJointAdd... functions, are not included.
    - dJointGetFeedback: The struct that dJointSetFeedback has set, or NULL. [guide] */
ODE_API void dJointSetFeedback(dJointID joint, dJointFeedback* feedback);
ODE_API dJointFeedback* dJointGetFeedback(dJointID joint);

/** One of the bodies may be 0: the world.
    - dConnectingJoint: A joint between body1 and body2, the one attached most recently, or 0.
    - dConnectingJointList: Write all joints between body1 and body2, most recently attached first, to the
      caller's array list (as many as dBodyGetNumJoints says are enough) and return how many. [0.16] */
ODE_API dJointID dConnectingJoint(dBodyID body1, dBodyID body2);
ODE_API int dConnectingJointList(dBodyID body1, dBodyID body2, dJointID* list);

/** body1 must not be 0; body2 may be: the world.
    - dAreConnected: 1 if a joint connects body1 and body2 directly, else 0.
    - dAreConnectedExcluding: 1 if a joint of another type than joint_type (usually dJointTypeContact)
      connects body1 and body2 directly, else 0. [0.16] */
ODE_API int dAreConnected(dBodyID body1, dBodyID body2);
ODE_API int dAreConnectedExcluding(dBodyID body1, dBodyID body2, int joint_type);

#ifdef __cplusplus
}
#endif

#include <ode/objects_joints.h>

#endif
