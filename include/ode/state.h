/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The state of worlds as bytes, and of many bodies and joints as arrays. Included by ode/ext.h. */
#ifndef _ODE_STATE_H_
#define _ODE_STATE_H_

#include <ode/common.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter state States of worlds

    A world's state is all that a step changes and later steps read: poses, velocities and forces of bodies,
    which of them are enabled, asleep or kinematic, what auto-disabling has seen, the impulses that joints and
    contacts start from, settings of motors, stops and softness, contacts that the world manages, the seed of
    random orders, and where the geoms of its contact space are that belong to no body. A world that is given
    its state back goes on with the same bits, on any number of threads and any machine; so does another world
    of the same structure.

    Structure is what stands: bodies, joints and geoms in the order of their creation, masses, shapes, what
    hangs on which body and which bodies a joint joins; contact joints that exist are joints. Not in the state
    are user data, callbacks, materials, anchors and axes of joints, and the settings of the world and those
    of bodies that no step changes (damping, thresholds).

    Arguments:
    - world: the world.

    Refused: a world, body or joint that is 0 or destroyed; null pointers; what each function names;
    [dWorldGetState, dWorldSetState] a call during a step; [dWorldSetState] bytes that are no state of this
    version and precision, have changed or end too early, a world of another structure (the message names the
    first thing that differs), a geom of the world in a space that is being collided; [dBodiesSet] as
    dBodySetPosition and its sisters. Nothing changes then, and the answer is 0. */

/** Returns how many bytes the state has now: another number when contacts come and go. [ours] */
ODE_API size_t dWorldGetStateSize(dWorldID world);

/** Write the state to buffer, as many bytes as dWorldGetStateSize returns; size is how many the buffer has.
    The format has a version (that before is read, others are refused by name), is little endian, and has a
    checksum. Returns 1. Refused: a buffer that is too small. [ours] */
ODE_API int dWorldGetState(dWorldID world, void* buffer, size_t size);

/** Give the world the state that dWorldGetState has written to buffer, this world's or that of another one of
    the same structure; size is how many bytes the buffer has, those behind the state's end are not looked at.
    Geoms are marked as moved, and no callback is called. Points that dWorldGetContacts returns lie where the
    bodies are now until the next step. Returns 1. [ours] */
ODE_API int dWorldSetState(dWorldID world, const void* buffer, size_t size);

/** What has changed since another state, as bytes.
    - dWorldGetStateDelta: Write to out what dWorldGetState would write, as a difference from base, a state of
      base_size bytes of the same structure: what sleeps costs next to nothing. capacity is how many bytes out
      has; 0: ask for the number alone, out may then be 0. Returns how many bytes the difference has; more
      than capacity: nothing was written.
    - dWorldSetStateDelta: Give the world the state that base and the difference, delta of delta_size bytes,
      make up. Returns 1. Refused: another base than the one it was made from. [ours] */
ODE_API size_t dWorldGetStateDelta(dWorldID world, const void* base, size_t base_size, void* out,
                                   size_t capacity);
ODE_API int dWorldSetStateDelta(dWorldID world, const void* base, size_t base_size, const void* delta,
                                size_t delta_size);

/** Keep the states after the last steps inside the world, so that steps can be taken back.
    - dWorldSetHistory: Keep the state now and after each of the coming steps, so that the last `frames` steps
      can be taken back; 0, the default: none. What was kept before is dropped. What the program destroys
      meanwhile is refused from then on, as always, but its memory is kept until no state has it. Returns 1.
      Refused: a number outside 0 ... 100000.
    - dWorldGetHistory: Returns that number. [ours] */
ODE_API int dWorldSetHistory(dWorldID world, int frames);
ODE_API int dWorldGetHistory(dWorldID world);

/** Take back the last `frames` steps, and all that the program has done since: the world goes on with the same
    bits as after that step. What has been destroyed since comes back under its handle, with data pointer, mass
    and attachments; what has been created since is destroyed, contact objects of ODE's way too. Returns 1.
    Refused, with nothing changed: more than dWorldGetHistoryFrames, a call during a step; by name, what cannot
    come back: another shape of a geom, drives that are new, destroyed spaces, transforms and geoms of a class
    of the program; fluids, vehicles or wheels made or lost; with couplings, `joints` or bodies made or lost. [ours] */
ODE_API int dWorldRollBack(dWorldID world, int frames);

/** What the history has.
    - dWorldGetHistoryFrames: Returns how many steps can be taken back now. A step without memory for its state
      sends a message, and the history begins again: then 0.
    - dWorldGetHistorySize: Returns the bytes that the states take, without objects that may come back. [ours] */
ODE_API int dWorldGetHistoryFrames(dWorldID world);
ODE_API size_t dWorldGetHistorySize(dWorldID world);

/** The parts of a body's state that arrays hold, in this order, added up; as many numbers of each as the text
    says. */
typedef enum {
    dStatePosition = 1,   /**< 3, m */
    dStateQuaternion = 2, /**< 4: w x y z */
    dStateLinearVel = 4,  /**< 3, m/s */
    dStateAngularVel = 8, /**< 3, rad/s */
    dStateForce = 16,     /**< 3: accumulated for the next step, N */
    dStateTorque = 32,    /**< 3: likewise, N m */
    dStateEnabled = 64    /**< 1: 1 or 0 */
} dStateField;

/** States of count bodies, which may be of several worlds, as arrays of count rows. A row has the parts that
    fields, a sum of dStateField, names, and begins stride numbers after the one before; stride 0: rows follow
    each other without gaps. Refused: a negative count, fields that are none, a stride above 0 and shorter
    than a row.
    - dBodiesGetStates: Write the states of bodies to the rows of out. Returns 1.
    - dBodiesSetStates: Set the states of bodies from the rows of in, as dBodySetPosition and its sisters do:
      geoms are marked as moved once, dStateEnabled wakes bodies or disables them. Of a body that is named
      twice the later row counts. Returns 1. Refused, all of them: a row with a number that is not finite or a
      quaternion that is zero. [ours] */
ODE_API int dBodiesGetStates(const dBodyID* bodies, int count, unsigned fields, dReal* out, int stride);
ODE_API int dBodiesSetStates(const dBodyID* bodies, int count, unsigned fields, const dReal* in, int stride);

/** Read the coordinates of the axes of count joints: positions into value and rates into rate, either of which
    may be 0, as dJointGetAxisPosition and dJointGetAxisRate return them. Rows have stride numbers; of each
    joint as many axes as fit, the rest is 0. Returns 1. Refused: a negative count, a stride below 1. [ours]
 */
ODE_API int dJointsGetStates(const dJointID* joints, int count, dReal* value, dReal* rate, int stride);

/** What a world has, from the oldest to the youngest, as many as capacity says; 0: ask for the number alone,
    the array may then be 0. Refused: a capacity below 0.
    - dWorldGetBodies: Write the bodies of the world to the array bodies. Returns how many there are.
    - dWorldGetJoints: Write the joints of the world, contact joints too, to the array joints. Returns how
    many there are. [ours] */
ODE_API int dWorldGetBodies(dWorldID world, dBodyID* bodies, int capacity);
ODE_API int dWorldGetJoints(dWorldID world, dJointID* joints, int capacity);

#ifdef __cplusplus
}
#endif

#endif
