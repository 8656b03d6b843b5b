// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What this library adds to ODE's interface. Not included by ode/ode.h: a program that includes
// this file has decided to depend on this library and not on the original one. One more name that only
// libode_single has, dSinglePrecisionProgram_LinkWith_ode_single, is in ode/odeconfig.h: it keeps programs
// for float and libraries for double apart.
#ifndef _ODE_EXT_H_
#define _ODE_EXT_H_

#include <ode/collision.h>
#include <ode/common.h>
#include <ode/contacts.h>
#include <ode/mass.h>
#include <ode/steppers.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter ext What this library adds

    Arguments:
    - world: the world.

    Refused: a world that is 0 or destroyed; null pointers; numbers that are not finite; what each function
    names. Nothing changes then, and the answer is 0. */

/** What the last step of a world did. Sums and worst values over its islands. Lengths in m, angles in
    rad, energies in J. */
typedef struct dWorldStepReport {
    unsigned struct_size;     /**< sizeof(dWorldStepReport), set by the caller */
    int islands;              /**< islands that were simulated */
    int bodies;               /**< bodies in them */
    int joints;               /**< joints in them that gave at least one row */
    int rows;                 /**< constraint rows, all islands together */
    double residual;          /**< worst natural residual over the islands, relative; 0 = solved exactly */
    int iterations;           /**< solver iterations, or pivots of the exact solver, summed over islands */
    int fallbacks;            /**< islands that needed a more careful method than the first one */
    int contained_islands;    /**< islands kept from spreading bad numbers: velocities kept, forces zero */
    int factorisations;       /**< sparse factorisations, summed over islands */
    double joint_error;       /**< worst distance that a joint should hold at zero, at the step's beginning */
    double joint_angle_error; /**< the same for angles, rad */
    double penetration;       /**< deepest contact beyond the surface layer, at the step's beginning */
    double energy_before;     /**< kinetic energy plus that of weight, at the step's beginning */
    double energy_after;      /**< the same at its end, before the bodies' own damping */
    int projections;          /**< Newton steps of dWorldSetStepProjection, summed over islands */
    int projections_open;     /**< islands that they left above the tolerance */
    double projection_error;  /**< worst error that they left, in the unit of the tolerance */
    int stopped;              /**< bodies that continuous collision (dGeomSetContinuous) has stopped */
} dWorldStepReport;

/** How an island was solved. */
typedef enum {
    dIslandMethodNone,       /**< nothing to solve */
    dIslandMethodDense,      /**< exact: active set on the dense matrix of a small island */
    dIslandMethodActiveSet,  /**< exact: active set on the sparse matrix */
    dIslandMethodInterior,   /**< exact: interior point, then the active set from its answer */
    dIslandMethodSweeps,     /**< dWorldQuickStep */
    dIslandMethodSmallSteps, /**< dWorldStepFast1 */
    dIslandMethodJointsExact /**< small steps with all joints solved together */
} dIslandMethod;

/** What the last step did with one island. Fields as in dWorldStepReport. */
typedef struct dIslandStepReport {
    unsigned struct_size;     /**< sizeof(dIslandStepReport), set by the caller */
    int method;               /**< one of dIslandMethod */
    dBodyID body;             /**< a body of the island; it may have been destroyed since the step */
    int bodies;               /**< its bodies */
    int joints;               /**< its joints that gave at least one row */
    int rows;                 /**< its constraint rows */
    int iterations;           /**< as in dWorldStepReport, as are those below without a text of their own */
    int factorisations;       /**< see dWorldStepReport */
    int fallback;             /**< 1: needed a more careful method than the first one */
    int contained;            /**< 1: kept from spreading bad numbers */
    double residual;          /**< see dWorldStepReport */
    double joint_error;       /**< see dWorldStepReport */
    double joint_angle_error; /**< see dWorldStepReport */
    double penetration;       /**< see dWorldStepReport */
    double energy_before;     /**< see dWorldStepReport */
    double energy_after;      /**< see dWorldStepReport */
    int projections;          /**< see dWorldStepReport */
    int projection_open;      /**< 1: left above the tolerance */
    double projection_error;  /**< see dWorldStepReport */
    int stopped;              /**< see dWorldStepReport */
} dIslandStepReport;

/** - dWorldSetStepReportMode: Switch the report of steps on (mode 1) or off (0, the default). Off costs
      nothing; on costs one more evaluation of the residual per step. Other values are refused.
    - dWorldGetStepReportMode: 1 if steps are reported, else 0. [ours] */
ODE_API void dWorldSetStepReportMode(dWorldID world, int mode);
ODE_API int dWorldGetStepReportMode(dWorldID world);

/** Copy the report of the world's last step. The caller sets report->struct_size; as many bytes as that
    are written, so an older program keeps working with a newer library. Returns 1, or 0 when the
    mode is off, no step has been made since it was switched on, or the call is refused (null
    argument, struct_size smaller than itself). [ours] */
ODE_API int dWorldGetStepReport(dWorldID world, dWorldStepReport* report);

/** Write to *report what the last step did in one island, 0 <= island < dWorldStepReport::islands, in the
   order in which ODE finds them: from the youngest body on. Another index is refused. [ours] */
ODE_API int dWorldGetIslandStepReport(dWorldID world, int island, dIslandStepReport* report);

/** - dWorldSetStepThreads: Set over how many threads a step of this world may spread its islands, the
      caller's included; 1 is the default, 0 means as many as the machine has processors, at most 64. A step
      has the same bits on any number of threads. Callbacks run on the caller's thread only; memory handlers
      set by the program may be called from the others. Threads are shared by all worlds, start with the
      first step that wants them and end with the last dCloseODE.
      dWorldSetStepIslandsProcessingMaxThreadCount limits them further. While an implementation is set by
      dWorldSetStepThreadingImplementation, its threads do the work and this number is kept for later.
      Negative numbers are refused.
    - dWorldGetStepThreads: The number that dWorldSetStepThreads has set, 1 at first. [ours] */
ODE_API void dWorldSetStepThreads(dWorldID world, int threads);
ODE_API int dWorldGetStepThreads(dWorldID world);

/** - dWorldSetQuickStepWarmStarting: Set how far a step of the world starts from the constraint forces of
      the last one: factor, 0 ... 1, of each stepper's usual share; default 1, 0 starts from nothing as ODE
      does. Contacts find their forces again although they are new joints in every step. The answer of
      dWorldStep does not depend on it, only the time it takes. Values outside 0 ... 1 are refused.
    - dWorldGetQuickStepWarmStarting: The factor that dWorldSetQuickStepWarmStarting has set, 1 at first.
      [ours] */
ODE_API void dWorldSetQuickStepWarmStarting(dWorldID world, dReal factor);
ODE_API dReal dWorldGetQuickStepWarmStarting(dWorldID world);

/** - dWorldSetContactCone: Set how contact joints bound friction in dWorldQuickStep and dWorldStepFast1.
      mode 0 (the default): as ODE does, each direction by itself, so that a box slides askew with up to 1.41
      times the friction. mode 1: in the plane as a whole, |(f1/l1, f2/l2)| <= 1 with the limits l1 and l2 of
      the two directions (mu times the normal force, or force bounds as the surface flags say), which with
      one mu is Coulomb's cone: the same in every direction, opposite to the slip. Contacts with both
      directions are meant; those with one, or that resist rolling, do not change, nor does dWorldStep, whose
      bounds are those of each row. Contacts that the world manages (ode/contacts.h) always have the cone.
      Costs a root and three divisions per contact and sweep. Other values are refused, as is a call during a
      step.
    - dWorldGetContactCone: The mode that dWorldSetContactCone has set, 0 at first. [ours] */
ODE_API void dWorldSetContactCone(dWorldID world, int mode);
ODE_API int dWorldGetContactCone(dWorldID world);

/** - dWorldSetManifoldFriction: Set how many frictions the points of one contact have in dWorldQuickStep and
      dWorldStepFast1. mode 0 (the default): one for each point. mode 1: one for all points of two bodies
      that follow each other with one normal (up to four), and for each patch of contacts that the world
      manages: a force in the plane at the centre of the normal forces, and a couple about the normal,
      bounded together. With N the sum of the normal forces and rho their mean distance from that centre,
      |f|^2 + (m/rho)^2 <= (mu N)^2: a body that only slides is braked by mu N in every direction, one that
      only turns on its face by mu N rho, one that does both by what an ellipsoid between them allows.
      Contacts that the world manages cost less, contact joints more (up to a fifth of the solver's time,
      since the box of the default needs no roots). Friction is still reported point by point
      (dJointFeedback, impulses of contacts that the world manages): each point has its part by its normal
      force, and these parts add up to the force and couple that acted. Contact joints have it whose mu is
      finite and the same in both directions; those with mu2, with force bounds instead of mu or with an
      infinite one, with one direction or against rolling do not change. Surface motion is kept, slip becomes
      that of all points side by side. dWorldStep, which is exact for each row, does not use it. Other values
      are refused, as is a call during a step.
    - dWorldGetManifoldFriction: The mode that dWorldSetManifoldFriction has set, 0 at first. [ours] */
ODE_API void dWorldSetManifoldFriction(dWorldID world, int mode);
ODE_API int dWorldGetManifoldFriction(dWorldID world);

/** - dWorldSetExactRotation: Set how dWorldStep and dWorldQuickStep turn bodies: mode 0 (the default) as ODE
      does, 1 exactly. Exactly means: the orientation turns by the exponential map, so a spin w held for h
      turns by w h and not by 2 atan(w h/2); and the gyroscopic torque follows the implicit midpoint rule
      with that map, so that a body on which nothing acts keeps its energy and its angular momentum,
      direction included, to rounding (while |w| h < 2 rad; beyond, mostly energy and |L| still). ODE's rule
      damps tumbling away. Bodies under joints or contacts have the same torque in the velocity that the
      constraints start from; the angular velocity that is read of them is that of the middle of the last
      step, which satisfies the constraints; a body on which none has acted reads that of the end. Gyroscopic
      mode off (dBodySetGyroscopicMode) leaves the torque out and keeps the exact turn; a finite rotation
      axis (dBodySetFiniteRotationAxis in finite mode) still splits the turn as the program asked; the
      largest angular speed cuts in as always. dWorldStepFast1 is not affected: its small steps turn as
      before. Costs about 0.4 microseconds per body. Other values are refused, as is a call during a step.
    - dWorldGetExactRotation: The mode that dWorldSetExactRotation has set, 0 at first. [ours] */
ODE_API void dWorldSetExactRotation(dWorldID world, int mode);
ODE_API int dWorldGetExactRotation(dWorldID world);

/** - dWorldSetExactSubsteps: Set into how many equal parts dWorldStep divides its step; 1 is the default.
      Each part is an exact solve of its own with the poses, joints, stops and rebounds of that moment, while
      contacts stay those that the step began with: their depth follows the motion, one that has opened may
      close but not enter, and a bounce happens in the first part. Forces are held over the step. ERP and CFM
      keep their meaning for the whole step: the parts use those that stand for the same spring and damper,
      so that a spring stays the same spring. Joint feedback is the mean force over the step; damping, sleep
      and callbacks come once. Errors of joints and of free motion fall as in as many steps, with one
      collision instead of n; time grows with n. A projection (dWorldSetStepProjection) follows the last
      part. Values outside 1 ... 1000 are refused.
    - dWorldGetExactSubsteps: The number of parts that dWorldSetExactSubsteps has set, 1 at first. [ours] */
ODE_API void dWorldSetExactSubsteps(dWorldID world, int parts);
ODE_API int dWorldGetExactSubsteps(dWorldID world);

/** - dWorldSetStepProjection: Set how many steps (iterations) of Newton's method on positions may follow
      each dWorldStep, 0 (the default, as in ODE) to 100; 8 are plenty, and most steps take one. dWorldStep
      solves for velocities: at its end joints are open by about (w h)^2/2 of a lever that turns at w, and
      more where a light link carries a heavy load. The projection closes joints (all rows that hold
      positions, and stops that act) until the worst error is below the tolerance, and takes from the depth
      of contacts the share that is their ERP, moving bodies as little as their masses allow. Contacts and
      stops are then not pushed out by velocities, so nothing is thrown off. It never pulls a contact or a
      stop that has opened. It leaves springs alone (rows whose softness, by CFM, is more than a thousandth
      of what the bodies give), motors and friction. Contacts keep the surface layer, and half the tolerance
      so that they are found again. Errors that contradict each other are left at their least squares; a
      Newton step that does not make the errors smaller is shortened, and at last taken back. Velocities are
      not changed. The joints' tension is felt in the inertia of the bodies that they hold, where the step is
      too long to follow how fast it swings them: without that, light links under a heavy load thrash about.
      The step report says what was done. Costs about as much again as the step. Other values are refused.
    - dWorldGetStepProjection: The number of iterations that dWorldSetStepProjection has set, 0 at first.
      [ours] */
ODE_API void dWorldSetStepProjection(dWorldID world, int iterations);
ODE_API int dWorldGetStepProjection(dWorldID world);

/** - dWorldSetStepProjectionTolerance: Set the error (tolerance) that the projection need not remove: of
      angles in rad, of lengths as a share of the longest lever (from the centre of a body to the joint, at
      least its radius of gyration). Default 1e-4 (1e-3 in single precision); values outside 0 ... 1, and
      both ends, are refused.
    - dWorldGetStepProjectionTolerance: The tolerance that dWorldSetStepProjectionTolerance has set; at first
      1e-4, 1e-3 in single precision. [ours] */
ODE_API void dWorldSetStepProjectionTolerance(dWorldID world, dReal tolerance);
ODE_API dReal dWorldGetStepProjectionTolerance(dWorldID world);

/** @chapter continuous Continuous collision

    Without it a step moves bodies from one place to the next, and what is fast and thin passes what is thin.

    Arguments:
    - geom: any geom but a space.

    Refused: [dGeom] a geom that is a space, destroyed or 0; what each function names. Nothing changes then,
   and the answer is 0. */

/** What steps do about a geom's way from one place to the next. */
typedef enum {
    dContinuousOff,    /**< nothing: where it ends is what counts */
    dContinuousOn,     /**< it does not pass what it meets */
    dContinuousIgnored /**< it may be passed by those that pass nothing else: sensors */
} dContinuousMode;

/** - dGeomSetContinuous: Set what steps do about the geom's way: mode is one of dContinuousMode;
      dContinuousOff is the default. The body of a geom with dContinuousOn is looked at by every stepper when
      it has moved, in this step, by more than a small share of the geom's thickness (twice the radius of a
      ball inside): if on its way the geom goes deeper than about an eighth of its thickness into another
      one, the body stands still, from the moment when it met that geom, for the rest of the step, a hair
      deep, so that the next collision finds the contact. Velocities are kept. What only grazes, slides or
      rests is left as it is. Turning counts, up to half a turn in a step, and so does the motion of the
      other geom: two continuous ones stop both; what meets a moving body that is not continuous is carried
      on by it for the rest of the step. Met are all geoms in its outermost space that agree by category and
      collide bits and are enabled, planes, meshes and height fields included; those that push forwards only
      (meshes against spheres, capsules and cylinders, height fields) from their fronts. Not met are geoms of
      the same body, of bodies that a joint other than a contact connects with it, rays, classes of the
      program, pairs that the program has overridden (dSetColliderOverride), and what it already lies in when
      no contact joint acts between the two bodies: then the program has no use for the contact. Bodies that
      joints hold together stop together. Kinematic bodies are met, but never stopped.
      dWorldStepReport::stopped counts. A step without such geoms is not changed by a bit. Refused: other
      modes; dContinuousOn for a geom that is neither sphere, box, capsule, cylinder, convex, mesh nor a
      transform.
    - dGeomGetContinuous: The mode that dGeomSetContinuous has set, dContinuousOff at first. [ours] */
ODE_API void dGeomSetContinuous(dGeomID geom, int mode);
ODE_API int dGeomGetContinuous(dGeomID geom);

/** @chapter hulls Convex hulls

    Solids made of points alone, as geoms of class dConvexClass, and what such a geom was made into.

    Arguments:
    - space: the space to put a new geom into, or 0.
    - convex: a geom of class dConvexClass, however it was made.
    - room: how many of what is asked for the array holds, 0 or more; 0 to ask for the number alone, the
    array may then be null.

    Refused: a geom of another class, destroyed or 0; a space that is destroyed or being collided; null
    pointers; numbers that are not finite; what each function names. Nothing changes then, and the answer is
    0. */

/** The hull is that of pointcount points, 3 reals each, m, in the geom's frame; they are copied and may be
    in any order, equal, inside, in a line or in a plane with others. At most maxvertices of them become
    vertices, those that stand out farthest first (at least 4; 0: no limit). What lies in one plane becomes
    one face, within a millionth of the extent (the longest side of the points' bounding box; 1e-5 of it in
    single precision), and every point lies within twice that of all faces unless maxvertices left it out.
    The result does not depend on the order of the points. Refused: fewer than 4 points; points that are all
    in one plane to that measure; more than 2^24.
    - dCreateConvexHull: A new convex geom in the space, or (0) in none: the convex hull of the points.
    - dGeomSetConvexHull: Make the geom convex the convex hull of the points. [ours] */
ODE_API dGeomID dCreateConvexHull(dSpaceID space, const dReal* points, unsigned int pointcount,
                                  unsigned int maxvertices);
ODE_API void dGeomSetConvexHull(dGeomID convex, const dReal* points, unsigned int pointcount,
                                unsigned int maxvertices);

/** Coordinates are in the geom's frame, as dCreateConvex takes them.
    - dGeomConvexGetPoints: Write up to room of the vertices, 3 reals each, m, to points, in the order in
      which they were given. Returns how many vertices there are.
    - dGeomConvexGetPlanes: Write up to room of the planes of the faces, 4 reals each, to planes: the unit
      outward normal n, and n . p of the face's points. Returns how many planes there are.
    - dGeomConvexGetPolygons: Write up to room of the numbers that describe the faces to polygons: for each
      face the number of its corners and their places among the vertices, counter-clockwise seen from
      outside. Returns how many numbers there are. [ours] */
ODE_API int dGeomConvexGetPoints(dGeomID convex, dReal* points, int room);
ODE_API int dGeomConvexGetPlanes(dGeomID convex, dReal* planes, int room);
ODE_API int dGeomConvexGetPolygons(dGeomID convex, unsigned int* polygons, int room);

/** The mass is that of the solid in the geom's own frame, exactly: centre of mass, and inertia about the
    frame's origin. For a body, move it to its centre with dMassTranslate and the geom with it
    (dGeomSetOffsetPosition). Refused: a plate without volume.
    - dMassSetConvex: Set *m to the mass of the geom convex filled with density, kg/m^3.
    - dMassSetConvexTotal: Set *m to the mass of the geom convex that weighs total_mass, kg. [ours] */
ODE_API void dMassSetConvex(dMass* m, dReal density, dGeomID convex);
ODE_API void dMassSetConvexTotal(dMass* m, dReal total_mass, dGeomID convex);

/** @chapter solid Solid meshes

    Arguments:
    - mesh: a geom of class dTriMeshClass.

    Refused: a geom of another class, destroyed or 0; what each function names. Nothing changes then, and
    the answer is 0. */

/** - dGeomTriMeshSetSolid: Say whether the mesh is the solid that its triangles enclose (solid 1) or, as in
      ODE and by default, their surface (0). A sphere, box, capsule, cylinder or convex whose middle is
      inside a solid mesh is pushed out by the nearest way, however deep it is: dCollide gives up to 4
      contacts as with a plane across that way, with the nearest triangle as side; dGeomGetDistance is minus
      the depth along that way, and dSpaceOverlap reports it. One whose middle is outside meets the surface
      as before, and so do rays, planes, casts, height fields and other meshes. The middle is the origin of
      the geom's frame, of a convex the middle of its box. Costs a search for the nearest triangle. Refused:
      other values of solid; 1 for a mesh that is not closed, that is one with a triangle that has no
      neighbour over an edge or one wound the other way, or that looks inward (its volume is not positive).
    - dGeomTriMeshGetSolid: 1 if the mesh is a solid now, else 0: data that are not closed make it a surface
      for as long as it has them. [ours] */
ODE_API void dGeomTriMeshSetSolid(dGeomID mesh, int solid);
ODE_API int dGeomTriMeshGetSolid(dGeomID mesh);

/** @chapter field_holes Holes in height fields

    Cells of a height field may be missing: nothing touches what is inside a hole, and rays and questions go
    through. Cell (i, j) lies between the samples (i, j) and (i + 1, j + 1); a field of widthSamples by
    depthSamples samples has widthSamples - 1 by depthSamples - 1 cells, a field that repeats the same in
   every period. Heights of samples all of whose cells are missing are not looked at.

    A field that has a hole is no longer solid to any depth but a slab: under each triangle that is there the
    ground is as thick as its data's thickness (in m, straight down), with upright walls at the holes, and
   below it is open, so that what has fallen in may go on under the ground. A body in a hole is held by the
   walls, which push level, and one that overlaps ground at a hole goes out by the lesser way, up or over the
   wall; the ends of the walls below do not push. What has its middle (the origin of the geom's frame, of a
   convex the middle of its box) deeper under the surface than the thickness is under the ground and is not
   touched, wherever the hole is. Thickness 0 is a sheet without walls. The outer border of a field has no
   walls. Rays meet walls as they meet the surface; so do dGeomGetDistance, dSpaceOverlap and casts, which
   also see the surface from below.

    Arguments:
    - d: the data, built before. Building them again makes a field without holes.
    - i, j: a cell, counted from 0, i along the width and j along the depth.

    Refused: data that are 0, destroyed or not built; cells that the field has not; a call from a height
    function; what each function names. Nothing changes then, and the answer is 0. */

/** Which cells are missing: those whose byte is not 0, cell (i, j) being element i + j * widthCells of holes,
   which is copied; 0 for none. All holes from before are gone. Set while nothing is collided with the field;
   geoms stay where they are. widthCells, depthCells: the field's cells along its width and depth. Refused:
   other numbers of cells, no memory. [ours] */
ODE_API void dGeomHeightfieldDataSetHoles(dHeightfieldDataID d, const unsigned char* holes, int widthCells,
                                          int depthCells);

/** - dGeomHeightfieldDataSetHole: Take cell (i, j) away (hole 1) or put it back (0). Refused: other values
      of hole; no memory.
    - dGeomHeightfieldDataGetHole: 1 if cell (i, j) has been taken away, else 0. [ours] */
ODE_API void dGeomHeightfieldDataSetHole(dHeightfieldDataID d, int i, int j, int hole);
ODE_API int dGeomHeightfieldDataGetHole(dHeightfieldDataID d, int i, int j);

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
