// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays, overlaps, distances and shape casts without a callback. Included by ode/ext.h.
#ifndef _ODE_QUERIES_H_
#define _ODE_QUERIES_H_

#include <ode/collision.h>
#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter queries Questions to spaces

    What lies where in a space, without contacts and without a callback. Members of nested spaces, at any
   depth, count as members. Disabled geoms and those of no size are not seen, as dSpaceCollide does not see
   them, nor is anything in a disabled space. Answers do not depend on how a space is organised: where order
   matters, and between geoms at equal distance, the geom that has joined last comes first, as in
   dSpaceCollide. All lengths in m, all vectors in the world's frame.

    Arguments:
    - space: any space; it may be one that is being collided, and is then seen as when that began.
    - category, collide: what the question is as a geom would be: it sees the geoms whose collide bits have
   one of its category bits, or whose category bits have one of its collide bits. The same is asked of spaces,
   for all that is in them. ~0ul sees everything.
    - room: how many answers the array holds, 0 or more; 0 to ask for the number alone, the array may then be
    null.

    Refused: a space that is 0, destroyed or none; null pointers; numbers that are not finite; what each
    function names. Nothing changes then, and the answer is 0. While functions of the program are called
    (user classes, overridden pairs, functions of meshes and heights), the space is locked. */

/** What a question has found. */
typedef struct dQueryHit {
    dGeomID geom;    /**< the geom that was hit; 0: none, and all else is 0 */
    dVector3 pos;    /**< where, in the world */
    dVector3 normal; /**< unit, out of that geom's surface, against the ray or the motion (see there) */
    dReal distance;  /**< from the beginning of the ray or of the motion, m */
    int side;        /**< triangle of a mesh, as dContactGeom::side2; -1: it has none */
} dQueryHit;

/** The geom that a ray meets first, from origin into direction (of any length but 0), to the distance length
   (0 ... dInfinity), in *hit. Each geom is met as dCollide with a ray geom says, with the closest hit
   counted: one whose inside the ray starts in is met at its far wall, from inside; normals of meshes are
   those of their fronts. Returns 1, or 0 when nothing is met: then hit->geom is 0. Refused: a zero direction,
   a length below 0. [ours] */
ODE_API int dSpaceRayClosest(dSpaceID space, const dVector3 origin, const dVector3 direction, dReal length,
                             unsigned long category, unsigned long collide, dQueryHit* hit);

/** All geoms that the ray from origin into direction meets within length, each once, at its nearest hit, the
   nearest first; as many of them as there is room for in hits. The rest as dSpaceRayClosest. Returns how many
   there are. [ours] */
ODE_API int dSpaceRayAll(dSpaceID space, const dVector3 origin, const dVector3 direction, dReal length,
                         unsigned long category, unsigned long collide, dQueryHit* hits, int room);

/** Many rays at once: for ray i of count the answer of dSpaceRayClosest in hits[i], geom 0 if it meets
   nothing; origins and directions have 3 reals for each ray, lengths one. Over at most so many threads, the
   caller's included (threads 0: as many as there are processors); the answers have the same bits on any
   number. Where a function of the program would be called for any geom of the space, the caller's thread does
   all. Returns how many rays meet something. Refused, all of them: one ray that dSpaceRayClosest would
   refuse, a negative count or number of threads. [ours] */
ODE_API int dSpaceRayBatch(dSpaceID space, int count, const dReal* origins, const dReal* directions,
                           const dReal* lengths, unsigned long category, unsigned long collide,
                           dQueryHit* hits, int threads);

/** Which members of the space touch or overlap the geom, which may be one of them and is then left out; the
   one that has joined last first, as many as there is room for in geoms. The geom is any but a space; its own
   bits decide what it sees; geoms on its body are left out. Meshes are met at their triangles from either
   side, not where they enclose the geom; height fields are solid down to the bottom of their boxes. Classes
   of the program and overridden pairs are met as dCollide says. Returns how many there are. Refused: a geom
   that is a space, destroyed or 0. [ours] */
ODE_API int dSpaceOverlap(dSpaceID space, dGeomID geom, dGeomID* geoms, int room);

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

/** The signed distance of o1 and o2 and the points where it is attained, in *result, if it is no more than
   most (dInfinity: however far). Exchanging o1 and o2 changes no bit but signs and names. Solids that overlap
   have minus the least depth: moving o1 by -distance * normal parts them. A ray is the segment that it
   covers. A mesh is the surface that its triangles make: its distance is the least over triangles, so where
   some are cut, minus the depth of the deepest. Below a height field all is ground for solids and meshes,
   with the deepest contact of dCollide; to rays and other height fields it is a surface. Two planes that do
   not look at each other overlap without end: -dInfinity. Of a space the least over what is in it and whose
   bits agree with those of the other. Enabling, bodies and overridden pairs do not matter otherwise. Returns
   1; 0 if farther than most, or where there is no distance: geoms of no triangles, classes of the program,
   two endless height fields. Refused: equal geoms, one that is destroyed or 0. [ours] */
ODE_API int dGeomGetDistance(dGeomID o1, dGeomID o2, dReal most, dQueryDistance* result);

/** Convex geoms are sphere, box, capsule, cylinder, convex, ray, or a transform that holds one. What o
    overlaps at the beginning is met at distance 0, with the normal that leads out; what it only touches is
    met if the motion leads into it. Nothing is passed, however thin or small it is and however long the
    motion; a height field is met at its surface. Classes of the program are not met. Written to *hit: the
    way until then (distance, at most the length of motion), the point (pos) and the normal, out of what is
    met. Returns 1, or 0 if nothing is met: then hit->geom is 0. Refused: no motion; an o that is not convex.
    - dGeomCast: Whether the geom o meets one other geom, whatever its bits, when o is moved by motion (m,
      world, not zero) without turning. Refused: another geom that is o, destroyed, 0 or a space.
    - dSpaceCast: What the geom o meets first among all members of the space that o's bits let it see, except
      o itself and geoms on its body, when o is moved by motion (m, world, not zero) without turning; the
      newest of those met at once. [ours] */
ODE_API int dGeomCast(dGeomID o, const dVector3 motion, dGeomID other, dQueryHit* hit);
ODE_API int dSpaceCast(dSpaceID space, dGeomID o, const dVector3 motion, dQueryHit* hit);

#ifdef __cplusplus
}
#endif

#endif
