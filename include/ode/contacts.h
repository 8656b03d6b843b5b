// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts that a world finds and solves by itself. Included by ode/ext.h.
#ifndef _ODE_CONTACTS_H_
#define _ODE_CONTACTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter contacts Contacts that the world manages

    In ODE's way the program collides a space, makes a joint for every contact and destroys them all after the
   step. A world that is given a space does this itself, inside dWorldStep, dWorldQuickStep and
   dWorldStepFast1: it keeps pairs and contacts from step to step, does not collide again what has hardly
   moved, and uses as many threads as the world does (dWorldSetStepThreads). What it makes are no joints:
   dBodyGetNumJoints does not count them. The program's own joints, contact joints too, work beside them.

    Fastest are small steps, dWorldStepFast1 with about 4 of them: contacts are springs as stiff as the step
   allows, damped so that what is pushed out does not bounce; friction is a cone. In dWorldStep and
   dWorldQuickStep they are what contact joints with the same coefficients would be, with the world's ERP and
   CFM and friction in two directions. Contacts may overlap by the world's surface layer
   (dWorldSetContactSurfaceLayer), or by 0.2 mm if that is 0, and are then held, not pushed apart.

    Contacts are foreseen: what would meet within the step is stopped where it meets, if it is not so fast
   that it would be through (dGeomSetContinuous). Until a pair has met, nothing is told of it.

    A pair is left out if ODE's rules do so (category and collide bits, disabled geoms, geoms of one body), if
   a joint connects its bodies, if neither has a body that can move, or if the filter says so.

    Arguments:
    - world: the world.
    - geom: the geom.

    Refused: a world or geom that is 0 or destroyed; null pointers; numbers that are not finite; what each
    function names; [dWorldSetContactSpace, dWorldSetContactFilter] a call during a step. Nothing changes
    then, and the answer is 0. */

/** - dWorldSetContactSpace: Give the world the space whose geoms it is to keep apart by contacts that it
      manages; 0, the default: none. All contacts that the world knew are forgotten. A space that is
      destroyed is taken away from its world.
    - dWorldGetContactSpace: The space that dWorldSetContactSpace has set, or 0. [ours] */
ODE_API void dWorldSetContactSpace(dWorldID world, dSpaceID space);
ODE_API dSpaceID dWorldGetContactSpace(dWorldID world);

/** How a pair's coefficient is made of those of its two geoms. If they name different rules, the one that
    stands later here counts. */
typedef enum {
    dCombineDefault, /**< friction: the geometric mean; bounce and rolling: the larger */
    dCombineAverage, /**< half the sum */
    dCombineMinimum, /**< the smaller */
    dCombineProduct, /**< the product */
    dCombineMaximum  /**< the larger */
} dCombineRule;

/** What the surface of a geom is like. Of the two geoms of a pair, coefficients follow the rules named, the
    bounce speed is the larger, velocities of surfaces subtract, and softness adds up, as springs one behind
    the other do; their damping times then count by their softness. A soft contact is held by a spring of
    stiffness 1/softness and a damper of damping_time/softness at each of its points, beyond the surface
    layer, in all steppers. What is stiffer than 1e9 N/m counts as hard. */
typedef struct dMaterial {
    dReal friction;     /**< coefficient of Coulomb friction, 0 or more; dInfinity: does not slide. 0.6 */
    dReal bounce;       /**< share of the approach speed that comes back, 0 ... 1. 0 */
    dReal bounce_speed; /**< slower approaches do not rebound, m/s. 1 */
    dVector3 velocity;  /**< of the surface against the geom, in the geom's frame, m/s: a belt. 0 */
    dReal rolling;      /**< most torque against rolling and spinning, per force along the normal, m. 0 */
    dReal softness;     /**< depth per force at a point, m/N; 0: hard. 0 */
    dReal damping_time; /**< of a soft surface: damping over stiffness, s. 0 */
    int friction_rule;  /**< of dCombineRule, for friction. dCombineDefault */
    int bounce_rule;    /**< for bounce. dCombineDefault */
    int rolling_rule;   /**< for rolling. dCombineDefault */
} dMaterial;

/** - dGeomSetMaterial: Give the geom a copy of *material from the next step on; 0: the default of this
      chapter again. Returns 1. Refused: coefficients below 0; a bounce above 1; infinite rolling, softness
      or damping time; unknown rules.
    - dGeomGetMaterial: Write the geom's material to *material, the default if it has none. Returns 1. [ours]
 */
ODE_API int dGeomSetMaterial(dGeomID geom, const dMaterial* material);
ODE_API int dGeomGetMaterial(dGeomID geom, dMaterial* material);

/** Whether two geoms shall touch: not if it returns 0. Asked once when they come near each other, and again
   when they have been apart. */
typedef int dContactFilter(void* data, dGeomID o1, dGeomID o2);

/** Sets the function that is asked, with the given data; filter 0: none. It is called by the thread that
   steps, in the order of the pairs, and must not change the space or the world. [ours] */
ODE_API void dWorldSetContactFilter(dWorldID world, dContactFilter* filter, void* data);

/** What has happened to a pair in the last step. */
typedef enum {
    dContactBegins, /**< the geoms touch and did not before */
    dContactStays,  /**< they touch and did before */
    dContactEnds    /**< they touched before and do not */
} dContactEventKind;

/** One pair in one step. */
typedef struct dContactEvent {
    dContactEventKind kind; /**< which of them */
    dGeomID g1;             /**< has a body */
    dGeomID g2;             /**< 0, as g1, if it has been destroyed since */
} dContactEvent;

/** The events of the last step into events, as many as there is room for (0: ask for the number alone). First
   come pairs that the step has looked at, in the order in which their geoms were created, then pairs at rest,
   in one that depends on the calls made so far alone. A pair that ends because one of its geoms is
   destroyed or taken out of the space has its event in the step after that. Returns how many there are.
   [ours] */
ODE_API int dWorldGetContactEvents(dWorldID world, dContactEvent* events, int room);

/** A point of contact, as the last step has found and solved it. */
typedef struct dWorldContact {
    dGeomID g1;        /**< has a body */
    dGeomID g2;        /**< the other one */
    dVector3 pos;      /**< where, in the world, at the step's beginning, m */
    dVector3 normal;   /**< unit, into g1 */
    dReal depth;       /**< at the step's beginning; below 0: still apart then, m */
    dReal push;        /**< force along the normal, the mean over the step, N */
    dVector3 friction; /**< force of friction on g1, N */
} dWorldContact;

/** All points of the last step into contacts, as many as there is room for (0: ask for the number alone), in
   the order of events. Returns how many there are. [ours] */
ODE_API int dWorldGetContacts(dWorldID world, dWorldContact* contacts, int room);

#ifdef __cplusplus
}
#endif

#endif
