/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Spaces: containers of geoms that find the pairs whose bounding boxes overlap. A space is itself a
 * geom without a place and can be a member of another space.
 * While a space is being collided it is locked: the callback must not add, remove, destroy or move
 * its members (such calls are refused); making joints, dCollide, enabling and reading are allowed. */
#ifndef _ODE_COLLISION_SPACE_H_
#define _ODE_COLLISION_SPACE_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter spaces Spaces

    Arguments:
    - space: the space; of create functions the space to put the new one into, or 0.
    - geom: a geom, or (cast) a space.

    Refused: a space or geom that is 0 (where it may not be) or destroyed; [dSpaceAdd, dSpaceRemove,
    dSpaceDestroy, dSpaceClean] a space that is being collided. Nothing changes then, and the answer is 0. */

struct dContactGeom;

/** What dSpaceCollide and dSpaceCollide2 call for each pair; data is the caller's. A member that is a
    space comes as a geom (dGeomIsSpace tells). */
typedef void dNearCallback(void* data, dGeomID o1, dGeomID o2);

/** A new space that tests every pair: the quickest for a few dozen geoms. space: the parent, or 0. [0.16] */
ODE_API dSpaceID dSimpleSpaceCreate(dSpaceID space);

/** A new space for many geoms of similar and different sizes. space: the parent, or 0. [0.16] */
ODE_API dSpaceID dHashSpaceCreate(dSpaceID space);

/** Axis orders for sweep-and-prune spaces: 2 bits per axis, the first one lowest. */
#define dSAP_AXES_XYZ ((0) | (1 << 2) | (2 << 4))
#define dSAP_AXES_XZY ((0) | (2 << 2) | (1 << 4))
#define dSAP_AXES_YXZ ((1) | (0 << 2) | (2 << 4))
#define dSAP_AXES_YZX ((1) | (2 << 2) | (0 << 4))
#define dSAP_AXES_ZXY ((2) | (0 << 2) | (1 << 4))
#define dSAP_AXES_ZYX ((2) | (1 << 2) | (0 << 4))

/** A space for geoms that lie along an axis. axisorder: one of the codes above. [0.16] */
ODE_API dSpaceID dSweepAndPruneSpaceCreate(dSpaceID space, int axisorder);

/** A space for a world of known extent: its Center and half sizes Extents (3 reals each, m), and Depth,
    how often it is divided in four (not negative). Geoms outside are found all the same. In this library
    hash, sweep-and-prune and quadtree spaces are one structure that needs none of these hints: they are
    checked, and they are for speed only. [0.16] */
ODE_API dSpaceID dQuadTreeSpaceCreate(dSpaceID space, const dVector3 Center, const dVector3 Extents,
                                      int Depth);

/** Destroy a space; with it, in cleanup mode, its members, else they only leave it. [0.16] */
ODE_API void dSpaceDestroy(dSpaceID space);

/** - dHashSpaceSetLevels: Set the cell sizes of a hash space to 2^minlevel ... 2^maxlevel metres; default -3
      and 10. They are for speed only: no pair is lost whatever they are. minlevel > maxlevel is refused.
    - dHashSpaceGetLevels: Write the exponents of the smallest and the largest cell size of a hash space to
      *minlevel and *maxlevel: cells are 2^level metres. A null pointer is skipped. [0.16] */
ODE_API void dHashSpaceSetLevels(dSpaceID space, int minlevel, int maxlevel);
ODE_API void dHashSpaceGetLevels(dSpaceID space, int* minlevel, int* maxlevel);

/** - dSpaceSetCleanup: Say whether destroying the space destroys its members (mode not 0, the default) or
      leaves them.
    - dSpaceGetCleanup: Whether destroying the space destroys its members: 1 or 0. [0.16] */
ODE_API void dSpaceSetCleanup(dSpaceID space, int mode);
ODE_API int dSpaceGetCleanup(dSpaceID space);

/** - dSpaceSetSublevel: Set the number by which dSpaceCollide2 decides which of two spaces it opens: the one
      with the higher sublevel. Default 0; the library does not change it.
    - dSpaceGetSublevel: The number that dSpaceSetSublevel has set, 0 at first. [0.16] */
ODE_API void dSpaceSetSublevel(dSpaceID space, int sublevel);
ODE_API int dSpaceGetSublevel(dSpaceID space);

/** - dSpaceSetManualCleanup: Do nothing with mode, in ODE a hint on the lifetime of caches that threads have;
      neither Debian's ODE nor this library has such caches.
    - dSpaceGetManualCleanup: 1, whatever was set, as from Debian's ODE. [0.16] */
ODE_API void dSpaceSetManualCleanup(dSpaceID space, int mode);
ODE_API int dSpaceGetManualCleanup(dSpaceID space);

/** - dSpaceAdd: Add a geom that is in no space to the space.
    - dSpaceRemove: Take a direct member, geom, out of the space.
    - dSpaceQuery: 1 if geom is a direct member of the space, else 0. [0.16] */
ODE_API void dSpaceAdd(dSpaceID space, dGeomID geom);
ODE_API void dSpaceRemove(dSpaceID space, dGeomID geom);
ODE_API int dSpaceQuery(dSpaceID space, dGeomID geom);

/** Compute the bounding boxes of moved members now. dSpaceCollide does it by itself. [0.16] */
ODE_API void dSpaceClean(dSpaceID space);

/** - dSpaceGetNumGeoms: How many direct members the space has.
    - dSpaceGetGeom: Direct member number i, 0 ... dSpaceGetNumGeoms - 1, of the space. The order is not
      promised and may change when geoms move. An i that there is not is refused. [0.16] */
ODE_API int dSpaceGetNumGeoms(dSpaceID space);
ODE_API dGeomID dSpaceGetGeom(dSpaceID space, int i);

/** The class number of a space: dSimpleSpaceClass, dHashSpaceClass, ... [0.16] */
ODE_API int dSpaceGetClass(dSpaceID space);

#ifdef __cplusplus
}
#endif

#endif
