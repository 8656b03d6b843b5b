/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Contacts that a world finds and solves by itself. Included by ode/ext.h. */
#ifndef _ODE_CONTACTS_H_
#define _ODE_CONTACTS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter contacts World-managed contacts

    In ODE's way a program collides a space, makes a joint for every contact and destroys them all after the
    step. A world that is given a space does this itself inside dWorldStep, dWorldQuickStep, dWorldStepFast1
    and dWorldStepHybrid. It keeps pairs and contacts from step to step, does not collide again what has
    hardly moved, and uses as many threads as the world does (dWorldSetStepThreads). These contacts are no
    joints: dBodyGetNumJoints does not count them. Joints of the program, contact joints too, work alongside
    them.

    Contacts may overlap by the world's surface layer (dWorldSetContactSurfaceLayer), at most by 0.005 of
    half the size of what they carry; if that is 0, by 0.2 mm, at most by 0.001 of it. They are speculative:
    bodies that would meet within the step are stopped where they meet, on the way too, as far as it is at
    most 16 times what two solids are thick, or a solid's centre crosses a mesh; for the rest there is
    dGeomSetContinuous. A pair has no event before it touches.
    So callbacks of a mesh and heights of a function are called for where geoms will be, too; the colliders of
    user classes only for where they are.

    A pair is left out if ODE's rules say so (category and collide bits, disabled geoms, geoms of one body),
    if a joint connects its bodies, if neither has a body that can move, or if the filter rejects it. How
    each stepper solves these contacts: docs/solvers.md.

    Arguments:
    - world: the world.
    - geom: the geom.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may
      then be null.

    Refused: a world or geom that is 0 or destroyed; null pointers; numbers that are not finite; what each
    function names; [dWorldSetContactSpace,
    dWorldSetContactFilter, dWorldSetManifoldFunction] a call during a step. Nothing changes
    then, and the answer is 0. */

/** - dWorldSetContactSpace: Let the world find and solve the contacts between the geoms of a space; 0, the
      default, stops that. All contacts that the world knew are forgotten. A space that is destroyed is
      taken away from its world.
    - dWorldGetContactSpace: The space that dWorldSetContactSpace has set, or 0. [ours] */
ODE_API void dWorldSetContactSpace(dWorldID world, dSpaceID space);
ODE_API dSpaceID dWorldGetContactSpace(dWorldID world);

/** How a coefficient of a pair follows from those of its two geoms. If their rules differ, the one that is
    listed later here counts. */
typedef enum {
    dCombineDefault, /**< friction: the geometric mean; bounce and rolling friction: the larger */
    dCombineAverage, /**< half the sum */
    dCombineMinimum, /**< the smaller */
    dCombineProduct, /**< the product */
    dCombineMaximum  /**< the larger */
} dCombineRule;

/** The surface of a geom. For a pair, friction, bounce and rolling friction follow the rules; the bounce
    speed is the larger one, velocities of surfaces are subtracted, and compliances add up, as of springs in
    series. A compliant contact is held, beyond the surface layer and in all steppers, by a spring of
    stiffness 1/compliance and a damper of damping_time/compliance at each of its points. Stiffer than 1e9
    N/m counts as rigid. A surface with a friction axis, seen in the contact plane, bounds friction by the
    ellipse of its two coefficients; what slides is braked by the point of it that takes most power. Of two
    such surfaces the one whose coefficients differ more gives the axis. Each field ends with its default. */
typedef struct dMaterial {
    unsigned struct_size;      /**< sizeof(dMaterial), set by the caller or dMaterialInit */
    dReal friction;            /**< coefficient of Coulomb friction, 0 ... dInfinity (does not slide). 0.6 */
    dReal bounce;              /**< restitution: share of the approach speed that comes back, 0 ... 1. 0 */
    dReal bounce_speed;        /**< slower approaches do not rebound, m/s. 1 */
    dVector3 surface_velocity; /**< of the surface against the geom, in the geom's frame, m/s: a belt. 0 */
    dReal rolling_friction;    /**< largest torque against rolling and spinning, per normal force, m. 0 */
    dReal compliance;          /**< depth per force at a point, m/N; 0: rigid. 0 */
    dReal damping_time;        /**< of a compliant surface: damping over stiffness, s. 0 */
    int friction_rule;         /**< a dCombineRule for friction. dCombineDefault */
    int bounce_rule;           /**< for bounce. dCombineDefault */
    int rolling_friction_rule; /**< for rolling friction. dCombineDefault */
    int priority; /**< the geom of the larger one says friction, bounce and rolling friction alone. 0 */
    dReal cross_friction;   /**< coefficient across friction_axis, where that is not 0. 0.6 */
    dVector3 friction_axis; /**< in the geom's frame: friction counts along it; 0: in all directions. 0 */
    int kind; /**< 1 ... 255: the other geom's material of that number counts alone, if it has one. 0 */
} dMaterial;

/** Fills *material with the default of every field, and writes struct_size, which is sizeof(dMaterial), to
    it: dMaterialInit(&material, sizeof material). Returns 1. Refused: what dGeomSetMaterial refuses as too
    small or too large. [ours] */
ODE_API int dMaterialInit(dMaterial* material, unsigned struct_size);

/** A program whose dMaterial has fewer fields than the library's keeps working: the others have their
    defaults. Refused: a structure smaller than one that has friction alone, or larger than this library's.
    - dGeomSetMaterial: Give the geom a copy of *material from the next step on; 0: the default again.
      Returns 1. Refused: coefficients below 0; a bounce above 1; infinite rolling friction, compliance or
      damping time; unknown rules; a priority beyond a million; a kind outside 0 ... 255.
    - dGeomGetMaterial: Copy the geom's material to *material, the default if it has none. Returns 1.
      [ours] */
ODE_API int dGeomSetMaterial(dGeomID geom, const dMaterial* material);
ODE_API int dGeomGetMaterial(dGeomID geom, dMaterial* material);

/** Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    compliance. Clones and files of worlds have them.
    - dGeomSetFaceMaterial: Give the geom a copy of *material as its material of that number (1 ... 255), from
      the next step on; 0 removes it. Returns 1. Refused: another number; what dGeomSetMaterial refuses.
    - dGeomGetFaceMaterial: Copy that material, or the default material if there is none, to *material.
      Returns 1.
    - dGeomSetFaceMaterialNumbers: Take from numbers which material each of count faces has: with 0 or
      one without a material it has the geom's own. Count 0: all have. Returns 1. Refused:
      another class of geom; a count that is not 0 and not that of the faces.
    - dGeomGetFaceMaterialNumbers: Copy them, at most capacity, to numbers. Returns how many there are. [ours] */
ODE_API int dGeomSetFaceMaterial(dGeomID geom, int number, const dMaterial* material);
ODE_API int dGeomGetFaceMaterial(dGeomID geom, int number, dMaterial* material);
ODE_API int dGeomSetFaceMaterialNumbers(dGeomID geom, const unsigned char* numbers, int count);
ODE_API int dGeomGetFaceMaterialNumbers(dGeomID geom, unsigned char* numbers, int capacity);

/** Decides whether two geoms may touch: not if it returns 0. It is called once when they come near each
    other, and again when they have been apart. */
typedef int dContactFilter(void* data, dGeomID o1, dGeomID o2);

/** Sets a function that rejects pairs, called with the given data; filter 0: none. The thread that steps
    calls it, in the order of the pairs. It must not change the space or the world. [ours] */
ODE_API void dWorldSetContactFilter(dWorldID world, dContactFilter* filter, void* data);

/** One contact manifold for the coming step: points of two geoms with one normal. A function of the program
    changes what begins with accept, for this step alone; the rest is for it to read. What it sets to numbers
    that no dMaterial may have stays as the materials say. Its fields only grow at the end. */
typedef struct dManifold {
    unsigned struct_size;      /**< of the library's dManifold */
    dGeomID g1;                /**< has a body */
    dGeomID g2;                /**< the other one */
    int touched;               /**< 1: the two touched in the last step, too */
    int count;                 /**< how many points, 1 ... 4 */
    dVector3 pos[4];           /**< of the points, world, m */
    dReal depth[4];            /**< of the points, m; below 0: a gap that the step may close */
    dVector3 normal;           /**< unit, into g1 */
    dVector3 velocity;         /**< of g1 against g2 at the mean of the points, m/s */
    int accept;                /**< 0: the two pass through each other here. 1 */
    dReal friction;            /**< coefficient; infinity: it does not slide */
    dReal bounce;              /**< restitution, 0 ... 1 */
    dReal bounce_speed;        /**< slower approaches do not rebound, m/s */
    dReal rolling_friction;    /**< m */
    dReal compliance;          /**< of each point, m/N; 0: rigid */
    dReal damping_time;        /**< of a compliant point, s */
    dVector3 surface_velocity; /**< velocity of g1 against g2 that friction aims at, world, m/s */
    dReal cross_friction;      /**< coefficient across friction_axis */
    dVector3 friction_axis;    /**< world: friction counts along it; 0: in all directions */
    dReal max_impulse; /**< sum of the normal impulses in the step at most, N s; a share of each point, the
                            same for all. dInfinity */
} dManifold;

/** Sees every manifold of the world in every step, before it is solved, and may change it. data is the
    program's. It must not change the space or the world, and depend on nothing that steps change. */
typedef void dManifoldFunction(void* data, dManifold* manifold);

/** Sets a function that sees, changes and rejects the manifolds of each step, called with the given data;
    function 0: none. threads 0: the thread that steps calls it, in the order of the pairs; 1: any thread of
    the world may, several at once, and results do not depend on which. Files have no functions. Refused:
    other threads. [ours] */
ODE_API void dWorldSetManifoldFunction(dWorldID world, dManifoldFunction* function, void* data, int threads);

/** What has happened to a pair in the last step. */
typedef enum {
    dContactBegin,   /**< the geoms touch and did not before */
    dContactPersist, /**< they touch and did before */
    dContactEnd      /**< they touched before and do not */
} dContactEventKind;

/** One pair in one step. Elements of arrays, such as this, dWorldContact and dQueryHit, have no
    struct_size: their fields never change, and what may be added one day gets functions of its own. */
typedef struct dContactEvent {
    dContactEventKind kind; /**< what has happened */
    dGeomID g1;             /**< has a body */
    dGeomID g2;             /**< the other one; both are 0 if destroyed since the step */
} dContactEvent;

/** Copies the events of the last step, at most capacity of them, to events. Pairs that the step has updated
    come first, in the order in which their geoms were created; then pairs at rest, in an order that depends
    on the program's calls alone. A pair that ends because a geom is destroyed or taken out of the space has
    its event in the next step. Returns how many there are. [ours] */
ODE_API int dWorldGetContactEvents(dWorldID world, dContactEvent* events, int capacity);

/** A point of contact in the last step. */
typedef struct dWorldContact {
    dGeomID g1;              /**< has a body */
    dGeomID g2;              /**< the other one; both are 0 if destroyed since the step */
    dVector3 pos;            /**< where, in the world, at the step's beginning, m */
    dVector3 normal;         /**< unit, into g1 */
    dReal depth;             /**< at the step's beginning; below 0: the gap that the step has closed, m */
    dReal normal_force;      /**< along the normal, the mean over the step, N */
    dVector3 friction_force; /**< on g1, N */
} dWorldContact;

/** Copies the points of contact of the last step, at most capacity of them, to contacts, in the order of
    dWorldGetContactEvents. Returns how many there are. [ours] */
ODE_API int dWorldGetContacts(dWorldID world, dWorldContact* contacts, int capacity);

#ifdef __cplusplus
}
#endif

#endif
