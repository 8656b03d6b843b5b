// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Additions to shapes: continuous collision, convex hulls, solid meshes, holes in height fields. Included by
// ode/ext.h.
#ifndef _ODE_SHAPES_H_
#define _ODE_SHAPES_H_

#include <ode/collision.h>
#include <ode/common.h>
#include <ode/mass.h>

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif
