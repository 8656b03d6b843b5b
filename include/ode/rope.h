/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Ropes and bridges: chains of links between two points. Included by ode/ext.h. */
#ifndef _ODE_ROPE_H_
#define _ODE_ROPE_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter rope Ropes and bridges

    A rope is a row of links, bodies with geoms, on joints; a bridge is a rope of planks. They are bodies,
    geoms and joints like any others: states, histories, clones and files have them. Neighbours do not collide
    with each other where the world manages contacts; all else does. docs/guide/howto/ropes.md explains.

    Refused: null pointers that may not be null; [dRopeSettingsInit, dRopeCreate] settings whose struct_size is below that
    of their first two fields or above this library's; [dRopeCreate] settings with a field outside what it says, a world
    that is 0 or destroyed, a space or a body that is destroyed or of another world, numbers that are not finite, a call
    during a step; what each function names. Nothing changes then, and the answer is 0. */

/** Ends of a rope that are fastened. */
typedef enum {
    dRopeLoose,    /**< none */
    dRopeFrom = 1, /**< the first */
    dRopeTo = 2,   /**< the last */
    dRopeBoth = 3  /**< both */
} dRopeEnds;

/** What a rope is. Each field ends with its default. */
typedef struct dRopeSettings {
    unsigned struct_size; /**< sizeof(dRopeSettings), set by the caller or dRopeSettingsInit */
    int links;            /**< 1 ... 10000. 20 */
    dReal length;         /**< of all links, m; at least the distance of the two points; 0: that. 0 */
    dReal mass;           /**< of all links, kg, above 0. 1 */
    dReal radius; /**< of the links, which are capsules, m: above 0, less than half a link's length; of planks
                half their thickness. 0.02 */
    dReal width;  /**< m, 0 or more. Above 0, links are planks on hinges, as wide, across the way. 0 */
    int ends;     /**< dRopeEnds. dRopeBoth */
    dReal stretch; /**< how much longer the rope is, as a share, under `load`; 0: it does not stretch. With
               dampers. Planks do not: 0. 0 */
    dReal load;    /**< N, above 0. 1000 */
} dRopeSettings;

/** Fills *settings with the default of every field and writes its struct_size, which is sizeof(dRopeSettings):
    dRopeSettingsInit(&settings, sizeof settings). Returns 1. [ours] */
ODE_API int dRopeSettingsInit(dRopeSettings* settings, unsigned struct_size);

/** Lay a rope in the world from one point to another (m), its geoms in space, which may be 0; null settings
    are the defaults. What is longer than the way hangs in an arc, against the z axis or along gravity. Its ends are
    fastened to the bodies first and last, or to the world where these are 0. Write its links to bodies, and to
    joints, which may be 0, the joint before each link and that after the last: one more; 0 at a loose end.
    Returns how many links there are. Refused: points less than the thickness apart, longer ways than the
    rope; one link that is longer than the way. [ours] */
ODE_API int dRopeCreate(dWorldID world, dSpaceID space, const dVector3 from, const dVector3 to, dBodyID first,
                        dBodyID last, const dRopeSettings* settings, dBodyID* bodies, dJointID* joints);

#ifdef __cplusplus
}
#endif

#endif
