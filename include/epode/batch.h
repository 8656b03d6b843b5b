/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Batches: many copies of one robot, stepped side by side in the lanes of the machine's registers. docs/guide/batches.md says more. */
#ifndef _EPODE_BATCH_H_
#define _EPODE_BATCH_H_

#include <epode/robots.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter batches Batches of robots

    A batch holds n copies of a model as arrays of numbers: no world, no bodies. Joints hold by construction
    (generalised coordinates), and loops of the model with them; contacts, limits, dry friction and limited servos
    are solved to a tolerance, each copy for itself. What a copy does depends neither on its neighbours, nor on its place, the threads or the
    machine: the same bits. Units are SI, axes and coordinates those of the model (robots.h): positions as
    dRobotModelGetJoints numbers them; velocities one of a hinge or slider, three of a ball (angular, in its
    link's axes), six of a free joint (of the link's origin in the world's axes, then angular in the link's).

    Arguments:
    - batch: a batch that dBatchCreate has returned.
    - quantity: a dBatchQuantity.
    - values: floats or doubles, as the batch was created, (copies, size), a copy's numbers side by side.
    - first, count: which copies, count of them from first on.
    - method: a dBatchMethod.
    - distance: how far both sides of a derivative are from the state, in its unit, up to 0.5. 0: 1/131072, in floats
      1/256.
    - parameter: a dBatchParameter.

    Refused: a batch that is 0 or destroyed; null pointers; an unknown quantity; what each function names. Nothing
    changes then, and the answer is 0. One batch is used by one thread at a time. */

/** A batch. Its handle is never that of another one. */
typedef struct dxBatch* dBatchID;

/** How a batch steps. Start from dBatchOptionsInit. */
typedef struct dBatchOptions {
    unsigned struct_size; /**< sizeof(dBatchOptions), set by the caller or dBatchOptionsInit */
    int doubles;          /**< 1: the copies' numbers are doubles, 0: floats */
    int threads;          /**< that step, the caller included; 0: as many as the machine has */
    int max_sweeps;       /**< over all constraints in a step, 1 or more: 200 */
    dReal stepsize;       /**< s, above 0: 0.002 */
    dReal erp; /**< share of an overlap, or of a limit passed, that a step takes back, 0 to 1: 0.2 */
    dReal max_correction; /**< speed of taking back, m/s or rad/s, 0 or more: 2 */
    dReal reach;          /**< surfaces nearer than this are looked at in any case, m, 0 or more: 0.005 */
    dReal
        tolerance; /**< sweeps end when the last one changed no speed by more, m/s; 0: 1e-5 in floats, 1e-6 in doubles */
    int pinned; /**< 1: each thread but the caller's stays on a processor of its own, where the system can: 0 */
} dBatchOptions;

/** Fills *options with defaults, and writes struct_size, which is sizeof(dBatchOptions), to it. Returns 1.
    Refused: another struct_size. [ours] */
ODE_API int dBatchOptionsInit(dBatchOptions* options, unsigned struct_size);

/** What of the copies is read or written. */
typedef enum {
    dBatchPositions,     /**< coordinates; can be written */
    dBatchVelocities,    /**< velocities; can be written */
    dBatchControls,      /**< of actuators, in their order; can be written */
    dBatchAppliedForces, /**< along the velocities, N or N m, until they are changed; can be written */
    dBatchConstraintForces, /**< of the last step: three of each contact point (normal, two tangents), then of limits, dry friction,
                                 limited servos, couplings and tendons (limit, then drive), N or N m; at the end three torques of each contact
                                 point with torsional friction (about the normal, two tangents), N m, then of loops the force on the
                                 first link in the world's axes, of welds the torque too */
    dBatchBad,      /**< 1: the copy's numbers left the finite; it keeps its last state until it is reset */
    dBatchResidual, /**< what the last sweep of the last step changed, m/s */
    dBatchSweeps,   /**< of the last step */
    dBatchActivations, /**< of actuators with a filter between control and force, in their order; can be written */
    dBatchLinkPositions,   /**< of links' origins, in the world: three each, the world's own (0) first */
    dBatchLinkQuaternions, /**< of links, in the world */
    dBatchLinkVelocities, /**< angular, then linear of the point of the link that is at C, the centre of mass of its tree (all that
                                hangs on one link whose parent is the world), in the world's axes; MuJoCo's cvel */
    dBatchLinkInertias, /**< about C, in the world's axes: xx yy zz xy xz yz, mass times the place of the centre from C, mass;
                                MuJoCo's cinert */
    dBatchLinkForces, /**< of the last step's contacts and loops, on links: torque about C, force; MuJoCo's cfrc_ext. Nothing on the world */
    dBatchCentreOfMass,   /**< of all links */
    dBatchActuatorForces, /**< along the velocities, in this state under these controls */
    dBatchVelocityConstraintForces, /**< along the velocities, of the last step's contacts, loops, limits, dry friction, couplings */
    dBatchSensors /**< that the file names, in its order: of joints, actuators and frames in this state; accelerometer, force, torque
                       and touch of the last step, where it began. dBatchGetSensor has their places */
} dBatchQuantity;

/** Create a batch of `count` copies of the model, at the reference position and at rest. options may be NULL. The model may be
    destroyed afterwards. Destroy the batch with dBatchDestroy. Returns 0, with a message that names the element, when refused: a
    model with errors; what a batch does not have (tendons with a path on which something acts); count below 1; options out of bounds;
    too little memory. [ours] */
ODE_API dBatchID dBatchCreate(dRobotModelID model, int count, const dBatchOptions* options);

/** Destroys the batch. [ours] */
ODE_API void dBatchDestroy(dBatchID batch);

/** - dBatchGetNumCopies: Returns how many copies there are.
    - dBatchGetNumberSize: Returns the bytes of a number: 4 or 8.
    - dBatchGetNumThreads: Returns how many threads step.
    - dBatchGetSize: Returns how many numbers of the quantity a copy has. [ours] */
ODE_API int dBatchGetNumCopies(dBatchID batch);
ODE_API int dBatchGetNumberSize(dBatchID batch);
ODE_API int dBatchGetNumThreads(dBatchID batch);
ODE_API int dBatchGetSize(dBatchID batch, int quantity);

/** Returns how many numbers of dBatchSensors a sensor of the model has, as dRobotModelGetSensors numbers them; 0: a batch does not
    compute it (rangefinders: dBatchCastRays; kinds that worlds do not compute). *first, unless first is NULL, is where they begin. Refused: no
    such sensor. [ours] */
ODE_API int dBatchGetSensor(dBatchID batch, int sensor, int* first);

/** Of `count` copies from `first` on. Both return 1.
    - dBatchRead: Copies the quantity to values.
    - dBatchWrite: Takes it from values. Refused besides: a quantity that cannot be written, numbers that are not finite or
      whose squares would not be, quaternions of no length. [ours] */
ODE_API int dBatchRead(dBatchID batch, int quantity, int first, int count, void* values);
ODE_API int dBatchWrite(dBatchID batch, int quantity, int first, int count, const void* values);

/** Numbers of the model that copies may have of their own. */
typedef enum {
    dBatchGravity,   /**< three, m/s^2 */
    dBatchMasses,    /**< of links, kg; with one the link's inertia about its centre changes in proportion */
    dBatchFrictions, /**< of pairs of shapes that may touch, in the batch's order */
    dBatchArmatures, /**< of rotors, along the velocities, kg m^2 or kg */
    dBatchDampings,  /**< of joints, along the velocities, N m s or N s/m */
    dBatchStiffnesses, /**< of joints' springs, along the velocities, N m or N/m */
    dBatchGains,       /**< of actuators */
    dBatchTerrain, /**< three, m: by how much shapes of the world and of all that stands still are moved */
    dBatchTorsionalFrictions, /**< of pairs of shapes, m: 0 of those without (MJCF's condim below 4) */
    dBatchRollingFrictions    /**< of pairs of shapes, m: 0 of those without (MJCF's condim below 6) */
} dBatchParameter;

/** Of `count` copies from `first` on, (count, size) as in dBatchRead.
    - dBatchGetParameterSize: Returns how many numbers a copy has of the parameter, a dBatchParameter.
    - dBatchReadParameter: Copies them to `values`. Returns 1.
    - dBatchWriteParameter: Takes them from values, for those copies only. Returns 1. Refused besides: what is not finite or
      beyond 1e15; masses of moving links that are not above 0; negative frictions, armatures, dampings and stiffnesses;
      frictions against turning of pairs without them. [ours] */
ODE_API int dBatchGetParameterSize(dBatchID batch, int parameter);
ODE_API int dBatchReadParameter(dBatchID batch, int parameter, int first, int count, void* values);
ODE_API int dBatchWriteParameter(dBatchID batch, int parameter, int first, int count, const void* values);

/** Writes the Jacobians of a point of a link (in its frame, m; NULL: its origin) in the states of `count` copies from `first` on to
    values, (count, 6, velocities): linear, then angular, in the world's frame, what the velocities make of it. Returns 1. Refused
    besides: no such link; a point that is not finite or beyond 1e9. [ours] */
ODE_API int dBatchJacobian(dBatchID batch, int link, const dReal* point, int first, int count, void* values);

/** How derivatives of a step are found. */
typedef enum {
    dBatchDifferences, /**< central differences of steps, solved tightly: at a corner of the step the mean of both sides */
    dBatchExact /**< the implicit function theorem at the contacts, limits and friction that act in this step: at a corner the side
                     of the state */
} dBatchMethod;

/** Derivatives of the next state of `count` copies from `first` on, under the controls and applied forces that they have, over the
    state and the controls. Nothing moves. A state's n numbers: tangents of positions (along the velocities, of turns a rotation vector
    in the link's frame), velocities, activations.
    - dBatchGetTangentSize: Returns n.
    - dBatchLinearise: Writes d(next)/d(state), (count, n, n), to a, and d(next)/d(control), (count, n, controls), to b; of bad copies NaN.
      Of a control at an end of its range the inner side counts; outside it is 0. Returns 1. Refused besides: another method or
      distance; dBatchExact of a model with loops or friction against turning. [ours] */
ODE_API int dBatchGetTangentSize(dBatchID batch);
ODE_API int dBatchLinearise(dBatchID batch, int method, dReal distance, int first, int count, void* a,
                            void* b);

/** Writes derivatives of the next state over the numbers of the parameter, (count, n, its size), to values, as dBatchLinearise with
    that method does. distance is relative to the number; of one that is 0 both sides are a sixteenth of the
    usual distance away. Returns 1. [ours] */
ODE_API int dBatchLineariseParameter(dBatchID batch, int method, dReal distance, int parameter, int first,
                                     int count, void* values);

/** Bind an array of all copies to the quantity: from now on every step and reset writes it, and every step first
    takes what can be written from it. It is filled at once, and must live until it is replaced, unbound by NULL, or the batch is
    destroyed. Returns 1. [ours] */
ODE_API int dBatchBind(dBatchID batch, int quantity, void* values);

/** Steps all copies `steps` times, with the same controls and applied forces. Copies that are bad stay as they are. Returns 1.
    Refused: steps below 0; bound arrays with numbers that dBatchWrite refuses. [ours] */
ODE_API int dBatchStep(dBatchID batch, int steps);

/** Puts copies back to the reference position, at rest, with no controls and forces: those whose byte of mask, one a copy, is not 0;
    all if mask is NULL. Returns 1. [ours] */
ODE_API int dBatchReset(dBatchID batch, const unsigned char* mask);

/** Axes in which rays are given; all of them begin at the link's origin. */
typedef enum {
    dBatchRaysOfLink,  /**< the link's: rangefinders, lidars */
    dBatchRaysOfWorld, /**< the world's */
    dBatchRaysUpright  /**< z up, x where the link's x heads: scans of the ground's heights */
} dBatchRayAxes;

/** Casts rays from a link of each of `count` copies from `first` on. What the link itself has is not hit, unless it is the world.
    link: its number in the model. axes: a dBatchRayAxes, of origins (m, 0: all in the link's origin) and directions (any length but
    0), 3 reals a ray. ranges: floats or doubles, (count, rays), distances to the nearest shape, m, infinite beyond max_distance.
    shapes: the same of ints, which of the model's shapes, counted link by link, was hit, -1 for none; may be 0. The batch's threads
    share the work. Returns 1. Refused besides: no such link or axes; a direction of length 0; rays or max_distance below 0. [ours] */
ODE_API int dBatchCastRays(dBatchID batch, int link, int axes, int rays, const dReal* origins,
                           const dReal* directions, dReal max_distance, int first, int count, void* ranges,
                           int* shapes);

/** Returns how many copies are bad. [ours] */
ODE_API int dBatchCountBad(dBatchID batch);

#ifdef __cplusplus
}
#endif

#endif
