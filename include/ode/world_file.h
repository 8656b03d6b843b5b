/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Copies of whole worlds: clones and files. Included by ode/ext.h. */
#ifndef _ODE_WORLD_FILE_H_
#define _ODE_WORLD_FILE_H_

#include <ode/common.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter world_file Clones and files of worlds

    A copy of a world has its bodies, joints of all types, couplings, drives, settings, world-managed contacts
    and state, and geoms with their spaces. Its steps give the bits of the original's, with every stepper, on
    any number of threads. The guide has examples (docs/guide/howto/worlds.md).

    Arguments:
    - world: the world.
    - space: the outermost space of the geoms; 0: the world's contact space, if it has one. Geoms of bodies
      that are in no space of these are copied, too, and are in no space then.
    - path: the name of a file.

    Not in a copy: joint feedback, moved callbacks, threading implementations, the history, the diagnosis
    and the list of events, which are off. Joints of groups belong to no group in it. A clone has the user data
    and the functions of the original (of meshes, height fields and the contact filter); a file has none of
    them, and keeps the heights that a function returns.

    Refused: a world that is 0 or destroyed; null pointers; what each function names. Nothing is created or
    changed then, and the answer is 0. */

/** An object of a world and its counterpart in the clone: dWorldID, dBodyID, dJointID, dGeomID or dSpaceID. */
typedef struct {
    void* original; /**< a handle */
    void* copy;     /**< the handle of the counterpart */
} dHandlePair;

/** Clones of worlds, which share meshes and height fields. Refused, both: a call during a step, a space that
    is destroyed or lacks the contact space, geoms of the program's own classes.
    - dWorldClone: Create a world like this one and geoms like those of *space, which becomes the new space;
      space may be 0. Write to table the handles of world, bodies, joints and geoms, as many as capacity says:
      the oldest first, spaces before their members. Capacity 0: table may be 0. Returns the new world.
    - dWorldCountHandles: Returns how many rows of handles a clone has. [ours] */
ODE_API dWorldID dWorldClone(dWorldID world, dSpaceID* space, dHandlePair* table, int capacity);
ODE_API int dWorldCountHandles(dWorldID world, dSpaceID space);

/** Save structure and state, little endian, with a version and a checksum; later libraries of the same
    precision read it. Refused, both: what dWorldClone refuses.
    - dWorldSave: Write the world to the file path, which is replaced when all is written. Returns 1. Refused:
      a path that cannot be written.
    - dWorldSaveToBuffer: Write the same bytes to buffer, which has capacity bytes. Returns how many there are;
      more than capacity: nothing was written. Capacity 0: buffer may be 0. [ours] */
ODE_API int dWorldSave(dWorldID world, dSpaceID space, const char* path);
ODE_API size_t dWorldSaveToBuffer(dWorldID world, dSpaceID space, void* buffer, size_t capacity);

/** Create a world with its spaces, geoms, meshes and height fields, and set *space, which may be 0, to the
    outermost one. dGeomTriMeshGetData returns meshes, which are the program's to destroy. Refused, both: what
    is no world of a version and precision that this library reads, has changed, ends too early, or has what
    the interface would refuse.
    - dWorldLoad: Load the file path. Returns the world. Refused: a file that cannot be read.
    - dWorldLoadFromBuffer: Load the world that buffer, of size bytes, begins with. Returns it. [ours] */
ODE_API dWorldID dWorldLoad(const char* path, dSpaceID* space);
ODE_API dWorldID dWorldLoadFromBuffer(const void* buffer, size_t size, dSpaceID* space);

/** Makes the point offset (m, world) the new origin: subtracts it from the places of bodies, geoms of the space
    without bodies (0: the contact space), planes, anchors at the world, contacts, events, characters, vehicles
    and fluids. Nothing wakes or moves against anything else (docs/guide/howto/large_worlds.md). A history
    begins again; states of before do not fit where planes or joints are at the world. Returns 1. Refused: a call
    during a step or a collision of the space; a space with geoms of another world's bodies; coordinates that
    would be no usable numbers; an offset along z in a world with plane joints, which hold bodies at z = 0.
    [ours] */
ODE_API int dWorldShiftOrigin(dWorldID world, dSpaceID space, const dVector3 offset);

#ifdef __cplusplus
}
#endif

#endif
