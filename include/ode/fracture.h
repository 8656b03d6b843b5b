/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Fracture: bodies that break into given parts. Included by ode/ext.h. */
#ifndef _ODE_FRACTURE_H_
#define _ODE_FRACTURE_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter fracture Fracture

    A list of parts, geoms with densities, says what a body is made of; dFractureCreate makes one body of them.
    When it breaks, its geoms go over to new bodies, of one part each or of several that stay together, which
    go on as it moved: masses, inertias, momentum and angular momentum of the new bodies add up to its own. The
    geoms keep their handles, materials, bits and places, so dGeomGetBody says which body a part belongs to, and
    the list is all that a program keeps. States, histories, clones and files have bodies and geoms.
    docs/guide/howto/fracture.md explains.

    Arguments:
    - parts: the list, count of them.
    - count: how many, 1 ... dFractureMaxParts; of fractures 0 or more.
    - world: the world of the bodies.
    - radius: m, 0 or more; dInfinity: without bound.

    Refused: null pointers; numbers that are not finite; [dFracture] a list with a geom that is destroyed, in a
    locked space, or no solid (sphere, box, capsule, cylinder, cone, ellipsoid, tapered capsule, convex, closed
    mesh), with a density below 0; [dFracture] a geom that is twice in the list; a world that is 0 or destroyed;
    [dFractureCreate] a geom on a body; [dFractureBreak] a body that is 0 or destroyed, or has geoms that are no
    parts; [dFractureUpdate] a strength below 0; [dFracture] a call during a step, no memory; what each
    function names. Nothing changes then, and the answer is 0. */

/** How many parts a list may have. */
enum { dFractureMaxParts = 4096 };

/** One part. Elements of arrays, such as this and dFracture, have no struct_size. */
typedef struct dFracturePart {
    dGeomID geom;  /**< its shape, where it is */
    dReal density; /**< kg/m^3, 0 or more; 0: 1000 */
} dFracturePart;

/** What may break, and when. */
typedef struct dFracture {
    const dFracturePart* parts; /**< the list; must live as long as the call */
    int count;                  /**< of parts */
    dReal strength; /**< normal impulse of a blow of one other geom on one part that it withstands, N s, 0 or
                    more; dInfinity: any. A resting load exerts its weight times the step */
    dReal radius;   /**< m: parts within this distance of the hardest contact come off, each alone */
} dFracture;

/** Make a body of the parts, whose geoms are on no body, where they are: at their common centre of mass, of
    their masses and inertias added up, not turned. Returns the body. [ours] */
ODE_API dBodyID dFractureCreate(dWorldID world, const dFracturePart* parts, int count);

/** Break a body that has some of the parts. Those within radius of center (world, m; 0: all) become bodies of
    one part each; of the others those that touch each other stay together. The new bodies have the settings,
    data pointer and velocities of the old one, which is destroyed; joints are left without it. Of a
    kinematic body, what comes off is dynamic and the rest kinematic. Returns how many bodies it has become;
    0, with nothing changed, if it does not break. [ours] */
ODE_API int dFractureBreak(const dFracturePart* parts, int count, dBodyID body, const dVector3 center,
                           dReal radius);

/** Break whatever the last step has hit harder than its strength: each body that has two or more parts of one
    of count fractures. World-managed contacts count (dWorldSetContactSpace), with what will stop the approach
    that is left. The blow then has the strength and no more: a ball goes on through a pane with what is left of
    its momentum. What was overloaded most breaks first. A body with geoms that are no parts
    stays whole, with a message. Call it before each step. Returns how many bodies broke. [ours] */
ODE_API int dFractureUpdate(dWorldID world, const dFracture* fractures, int count);

#ifdef __cplusplus
}
#endif

#endif
