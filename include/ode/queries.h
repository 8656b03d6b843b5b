/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Rays, overlaps, distances and shape casts without a callback. Included by ode/ext.h. */
#ifndef _ODE_QUERIES_H_
#define _ODE_QUERIES_H_

#include <ode/collision.h>
#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter queries Spatial queries

    What lies where in a space, without contacts and without a near callback. Members of nested spaces, at
    any depth, count as members. Disabled geoms and those of zero size are not found, as dSpaceCollide does
    not find them, nor is anything in a disabled space. Results do not depend on how a space is organised:
    where order matters, and between geoms at equal distance, the geom that has joined last comes first. All
    lengths in m, all vectors in the world's frame.

    Arguments:
    - space: any space; it may be one that is being collided, and is then seen as when that began.
    - filter: what the query finds, a dQueryFilter; 0: what each function says.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may
      then be null.

    Refused: a space that is 0, destroyed or none; [dSpace] a filter smaller than one that has the two bit
    fields alone or larger than this library's, or one whose skip_body is destroyed; null pointers; numbers
    that are not finite; what each function names. Nothing changes then, and the answer is 0. While
    functions of the program are called (filters, user classes, overridden pairs, functions of meshes and
    heights), the space is locked. */

/** Decides whether a query keeps a geom that it has met: not if it returns 0. data is the filter's; geom is
    the one that the result would name. It is called on the caller's thread, the geom that has joined last
    first, but not for geoms farther than one that has been kept already where the nearest is asked for. It
    must not change the space. */
typedef int dQueryCallback(void* data, dGeomID geom);

/** What a query finds. A geom is left out if its bits do not agree, if it is on skip_body, or if the
    callback rejects it. The same bits are asked of nested spaces, for all that is in them. Each field ends
    with its default. */
typedef struct dQueryFilter {
    unsigned struct_size;        /**< sizeof(dQueryFilter), set by the caller or dQueryFilterInit */
    unsigned long category_bits; /**< finds geoms whose collide bits have one of these ... ~0ul */
    unsigned long collide_bits;  /**< ... or whose category bits have one of these. ~0ul */
    dBodyID skip_body;           /**< leave the geoms of this body out; 0: none. 0 */
    dQueryCallback* callback;    /**< has the last word; 0: none. 0 */
    void* data;                  /**< for the callback. 0 */
    int skip_overlaps; /**< 1: casts of shapes leave out what overlaps the shape at the beginning, of meshes and
                            height fields those triangles. 0 */
} dQueryFilter;

/** Fills *filter with the default of every field, a filter that finds everything, and writes struct_size,
    which is sizeof(dQueryFilter), to it: dQueryFilterInit(&filter, sizeof filter). Returns 1. [ours] */
ODE_API int dQueryFilterInit(dQueryFilter* filter, unsigned struct_size);

/** What a query has hit. */
typedef struct dQueryHit {
    dGeomID geom;    /**< the geom that was hit; 0: none, and all else is 0 */
    dVector3 pos;    /**< where, in the world */
    dVector3 normal; /**< unit, out of that geom's surface, against the ray or the motion */
    dReal distance;  /**< from the beginning of the ray or of the motion, m */
    int side;        /**< triangle of a mesh, as dContactGeom::side2; -1: it has none */
} dQueryHit;

/** Finds the geom that a ray hits first and writes it to *hit. The ray goes from origin in direction (of
    any length but 0) to the distance length (0 ... dInfinity). Each geom is hit as dCollide with a ray geom
    says, with its closest hit; from inside, at its far wall. A surface that the ray leaves outward at its
    origin is not hit there. A null filter finds everything. Returns 1, or
    0 if nothing is hit: then hit->geom is 0. Refused: a zero direction; a length below 0. [ours] */
ODE_API int dSpaceRayClosest(dSpaceID space, const dVector3 origin, const dVector3 direction, dReal length,
                             const dQueryFilter* filter, dQueryHit* hit);

/** Finds all geoms that a ray hits, each once, and writes at most capacity of them to hits, the nearest
    first. The ray (origin, direction, length) and a null filter are as in dSpaceRayClosest. Returns how
    many there are. [ours] */
ODE_API int dSpaceRayAll(dSpaceID space, const dVector3 origin, const dVector3 direction, dReal length,
                         const dQueryFilter* filter, dQueryHit* hits, int capacity);

/** Casts count rays at once: hits[i] is the hit of dSpaceRayClosest for ray i. origins and directions have
    3 reals for each ray, lengths one. At most so many threads work, the caller's included (threads 0: one
    for each processor), with the same bits on any number; the caller's does all if the filter has a
    callback, or if a geom of the space would call a function of the program. A null filter finds
    everything. Returns how many rays hit something. Refused, all of them: a ray that dSpaceRayClosest would
    refuse; a negative count or number of threads. [ours] */
ODE_API int dSpaceRayBatch(dSpaceID space, int count, const dReal* origins, const dReal* directions,
                           const dReal* lengths, const dQueryFilter* filter, dQueryHit* hits, int threads);

/** Finds the members of the space that touch or overlap a geom, other than itself and geoms of its body,
    and writes at most capacity of them to geoms, the one that has joined last first. A null filter takes
    the geom's own bits. Meshes are surfaces, unless solid; height fields are solid down to the bottom of
    their boxes; classes of the program and overridden pairs are met as dCollide says. Returns how many
    there are. Refused: a geom that is a space, destroyed or 0. [ours] */
ODE_API int dSpaceOverlap(dSpaceID space, dGeomID geom, const dQueryFilter* filter, dGeomID* geoms,
                          int capacity);

/** How far two geoms are from each other. */
typedef struct dQueryDistance {
    dReal distance;  /**< m; below 0: they overlap, and this is minus the depth */
    dVector3 pos1;   /**< of o1, the point nearest to o2, or deepest in it, in the world */
    dVector3 pos2;   /**< of o2 the point that belongs to it: pos1 - pos2 = distance * normal */
    dVector3 normal; /**< unit, from o2 into o1 */
    dGeomID g1;      /**< the geom of pos1: o1, or what lies in it if it is a space or a transform */
    dGeomID g2;      /**< the same of pos2 */
    int side1;       /**< its triangle if g1 is a mesh, else -1 */
    int side2;       /**< the same of g2 */
} dQueryDistance;

/** Computes the signed distance of o1 and o2 and the points where it is attained, and writes them to
    *result if it is at most max_distance (dInfinity: however far). Solids that overlap have minus the least
    depth: moving o1 by -distance * normal parts them. Of a space counts the member nearest to the other
    geom whose bits agree with its bits. Returns 1; 0 if they are farther apart, or where there is no
    distance: geoms of no triangles, classes of the program, two endless height fields. Meshes, rays, planes
    and height fields: docs/guide/queries.md. Refused: equal geoms, one that is destroyed or 0. [ours] */
ODE_API int dGeomGetDistance(dGeomID o1, dGeomID o2, dReal max_distance, dQueryDistance* result);

/** The geom o moves by motion (m, world, not zero) without turning. It is a convex solid of any class, a
    ray, or a transform that holds one. What it overlaps at the beginning is hit at distance 0, with the
    normal that leads out; what it only touches is hit if the motion leads into it. Nothing is passed,
    however thin. Classes of the program are not met. Returns 1, or 0 if nothing is hit: then hit->geom is
    0. Refused: no motion; an o that is not convex.
    - dGeomCast: Find where the geom hits one other geom, whatever its bits, and write that to *hit.
      Refused: another geom that is o, destroyed, 0 or a space.
    - dSpaceCast: Find what the geom hits first in the space, other than itself and geoms of its body, and
      write that to *hit. A null filter takes the geom's own bits. [ours] */
ODE_API int dGeomCast(dGeomID o, const dVector3 motion, dGeomID other, dQueryHit* hit);
ODE_API int dSpaceCast(dSpaceID space, dGeomID o, const dVector3 motion, const dQueryFilter* filter,
                       dQueryHit* hit);

/** What a cast of a shape has hit. */
typedef struct dCastHit {
    dGeomID geom;         /**< the geom that was hit */
    dVector3 pos;         /**< where, in the world */
    dVector3 normal;      /**< unit, out of that geom: along it the two are nearest to each other */
    dReal distance;       /**< from the beginning of the motion, m */
    int side;             /**< triangle of a mesh; -1: it has none */
    dVector3 face_normal; /**< unit, of the face that was hit; of an edge or corner, of the face there that is
                               most against the motion. Round geoms: normal */
    dReal depth;          /**< of an overlap at the beginning, m; else 0 */
} dCastHit;

/** Finds all that the geom o would hit on its way, each geom once, where the motion meets it first, and
    writes at most capacity of them to hits, the nearest first. Motion, o and filter are as in dSpaceCast;
    nothing stops o. Returns how many there are. Refused: what dSpaceCast refuses. [ours] */
ODE_API int dSpaceCastAll(dSpaceID space, dGeomID o, const dVector3 motion, const dQueryFilter* filter,
                          dCastHit* hits, int capacity);

#ifdef __cplusplus
}
#endif

#endif
