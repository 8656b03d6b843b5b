/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Additions to shapes: continuous collision, convex hulls, solid meshes, holes in height fields. Included by
 * ode/ext.h; docs/guide/shapes.md says more of each. */
#ifndef _ODE_SHAPES_H_
#define _ODE_SHAPES_H_

#include <ode/collision.h>
#include <ode/common.h>
#include <ode/mass.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter more_shapes Cones, ellipsoids, tapered capsules

    Convex shapes beyond ODE's. They meet every other shape, in dCollide, queries and steps, as ODE's do. Put
    on a body as they are, their centre of mass is the body's: their origin is it. The depth of a point is
    positive inside, 0 on the surface, negative outside, m.

    Arguments:
    - space: the space to put a new geom into, or 0.
    - cone, ellipsoid, tapered_capsule: a geom of that class.
    - radius, length: of a cone, m: of its base, and from the base to the apex.
    - r1, r2: the radii of a tapered capsule's balls, m; its length is the distance of their centres.
    - rx, ry, rz: half the lengths of an ellipsoid along its own x, y and z axes, m.
    - x, y, z: a point of the world, m.
    - density: kg/m^3.
    - total_mass: kg.
    - direction: the axis, 1, 2 or 3 for x, y or z; the apex, or the ball r2, is on its positive side.

    Refused: a geom of another class, destroyed or 0; a space that is destroyed or being collided; null
    pointers; numbers that are not finite; [dCreateCone, dCreateEllipsoid, dCreateTaperedCapsule,
    dGeomConeSet, dGeomEllipsoidSet, dGeomTaperedCapsuleSet, dMassSetTapered] a negative size; what each
    function names. Nothing changes then, and the answer is 0. */

/** The classes beyond ODE's, as dGeomGetClass returns them. Their numbers follow the last of ODE's, which
    are those of the program's own classes, so that no number of ODE's changes: dGeomNumClasses counts ODE's
    classes and the program's, not these. [ours] */
enum { dConeClass = dGeomNumClasses, dEllipsoidClass, dTaperedCapsuleClass };

/** - dCreateCone: Create a conical geom in the space, or (0) in none. Its own z axis is its axis: the base,
    of that radius, lies at z = -length/4, the apex at z = 3 length/4, and the origin is the centre of mass.
    - dGeomConeSetParams: Set the cone's radius and length, m.
    - dGeomConeGetParams: Write the cone's radius to *radius and its length to *length, m.
    - dGeomConePointDepth: Return how deep the world's point (x, y, z) is inside the cone, m. [ours] */
ODE_API dGeomID dCreateCone(dSpaceID space, dReal radius, dReal length);
ODE_API void dGeomConeSetParams(dGeomID cone, dReal radius, dReal length);
ODE_API void dGeomConeGetParams(dGeomID cone, dReal* radius, dReal* length);
ODE_API dReal dGeomConePointDepth(dGeomID cone, dReal x, dReal y, dReal z);

/** - dMassSetCone: Set *m to the mass of a solid of that shape about the origin, its centre of mass.
    - dMassSetConeTotal: Set *m to the mass of a solid of that shape that weighs total_mass. Refused by both:
    other numbers of direction. [ours] */
ODE_API void dMassSetCone(dMass* m, dReal density, int direction, dReal radius, dReal length);
ODE_API void dMassSetConeTotal(dMass* m, dReal total_mass, int direction, dReal radius, dReal length);

/** - dCreateEllipsoid: Create a geom with these radii in the space, or (0) in none, about its origin.
    - dGeomEllipsoidSetRadii: Set the ellipsoid's radii along its own axes, m.
    - dGeomEllipsoidGetRadii: Write the ellipsoid's radii to result, 3 reals, m.
    - dGeomEllipsoidPointDepth: Return how deep the world's point (x, y, z) is inside the ellipsoid: the
      distance from its surface, m. Refused: an ellipsoid with a radius of 0. [ours] */
ODE_API dGeomID dCreateEllipsoid(dSpaceID space, dReal rx, dReal ry, dReal rz);
ODE_API void dGeomEllipsoidSetRadii(dGeomID ellipsoid, dReal rx, dReal ry, dReal rz);
ODE_API void dGeomEllipsoidGetRadii(dGeomID ellipsoid, dVector3 result);
ODE_API dReal dGeomEllipsoidPointDepth(dGeomID ellipsoid, dReal x, dReal y, dReal z);

/** - dMassSetEllipsoid: Set *m to the mass of a solid of these radii about the origin.
    - dMassSetEllipsoidTotal: Set *m to the mass of a solid of these radii that weighs total_mass. [ours] */
ODE_API void dMassSetEllipsoid(dMass* m, dReal density, dReal rx, dReal ry, dReal rz);
ODE_API void dMassSetEllipsoidTotal(dMass* m, dReal total_mass, dReal rx, dReal ry, dReal rz);

/** - dCreateTaperedCapsule: Create a tapered geom in the space, or (0) in none: the hull of two balls on its
      own z axis, r2 above r1. The origin is its centre of mass.
    - dGeomTaperedCapsuleSetParams: Set the geom's radii and length, m; the centre of mass stays the origin.
    - dGeomTaperedCapsuleGetParams: Write the geom's radii to *r1 and *r2 and its length to *length, m.
    - dGeomTaperedCapsulePointDepth: Return how deep the world's point (x, y, z) is inside the geom, m.
    [ours] */
ODE_API dGeomID dCreateTaperedCapsule(dSpaceID space, dReal r1, dReal r2, dReal length);
ODE_API void dGeomTaperedCapsuleSetParams(dGeomID tapered_capsule, dReal r1, dReal r2, dReal length);
ODE_API void dGeomTaperedCapsuleGetParams(dGeomID tapered_capsule, dReal* r1, dReal* r2, dReal* length);
ODE_API dReal dGeomTaperedCapsulePointDepth(dGeomID tapered_capsule, dReal x, dReal y, dReal z);

/** - dMassSetTaperedCapsule: Set *m to the mass of a solid of that shape about the origin, its centre of
    mass.
    - dMassSetTaperedCapsuleTotal: Set *m to the mass of a solid of that shape that weighs total_mass. Refused
      by both: other numbers of direction; two radii of 0. [ours] */
ODE_API void dMassSetTaperedCapsule(dMass* m, dReal density, int direction, dReal r1, dReal r2, dReal length);
ODE_API void dMassSetTaperedCapsuleTotal(dMass* m, dReal total_mass, int direction, dReal r1, dReal r2,
                                         dReal length);

/** @chapter triangles Surfaces to draw

    Arguments:
    - geom: a sphere, box, capsule, cylinder, convex, cone, ellipsoid or other convex solid.
    - capacity: how many triangles the array holds, 0 or more; 0 to ask for the number alone, the array may
      then be null.

    Refused: [dGeom] a geom that is no convex solid, destroyed or 0; null pointers; what each function names.
    Nothing changes then, and the answer is 0. */

/** Write the surface of the geom as triangles, and return how many there are. Each is 9 reals: three corners
    in the geom's frame, m, counter-clockwise from outside. Round solids are cut into that many segments
    around the z axis, and half as many along it; a convex has its faces. At most capacity are written to
    facets. Refused: segments below 4 or above 512. [ours] */
ODE_API int dGeomGetTriangles(dGeomID geom, int segments, dReal* facets, int capacity);

/** @chapter continuous Continuous collision

    Without it a step moves bodies from one place to the next, and what is fast and thin passes what is
    thin.

    Arguments:
    - geom: any geom but a space.

    Refused: [dGeom] a geom that is a space, destroyed or 0; what each function names. Nothing changes then,
    and the answer is 0. */

/** What steps do about the path of a geom from one place to the next. */
typedef enum {
    dContinuousOff,    /**< nothing: where it ends is what counts */
    dContinuousOn,     /**< it does not pass what it meets */
    dContinuousIgnored /**< continuous geoms may pass it: sensors */
} dContinuousMode;

/** - dGeomSetContinuous: Choose whether a fast geom stops at what it would have passed: mode is one of
      dContinuousMode, dContinuousOff by default. If the geom would go deeper than an eighth of its
      thickness into another one, its body stands still, for the rest of the step, from the moment when they
      met; velocities are kept. dWorldStepReport::stopped_bodies counts. Which geoms are met:
      docs/guide/shapes.md. Refused: other modes; dContinuousOn for a geom that is neither sphere, box,
      capsule, cylinder, convex, mesh nor a transform.
    - dGeomGetContinuous: The mode that dGeomSetContinuous has set, dContinuousOff at first. [ours] */
ODE_API void dGeomSetContinuous(dGeomID geom, int mode);
ODE_API int dGeomGetContinuous(dGeomID geom);

/** @chapter hulls Convex hulls

    Solids made of points alone, as geoms of class dConvexClass, and what such a geom was made into.

    Arguments:
    - space: the space to put a new geom into, or 0.
    - convex: a geom of class dConvexClass, however it was made.
    - capacity: how many elements the array has, 0 or more; 0 to ask for the number alone, the array may
      then be null.

    Refused: a geom of another class, destroyed or 0; a space that is destroyed or being collided; null
    pointers; numbers that are not finite; what each function names. Nothing changes then, and the answer is
    0. */

/** The hull is that of pointcount points, 3 reals each, m, in the geom's frame. They are copied and may be
    in any order and anywhere. At most maxvertices of them become vertices, the farthest out first (at least
    4; 0: no limit). Points in one plane, to a millionth of the extent (1e-5 in single precision), make one
    face. The result does not depend on the order of the points. Refused: fewer than 4 points; points that
    are all in one plane; more than 2^24.
    - dCreateConvexHull: A new convex geom in the space, or (0) in none: the convex hull of the points.
    - dGeomSetConvexHull: Make the geom convex the convex hull of the points. [ours] */
ODE_API dGeomID dCreateConvexHull(dSpaceID space, const dReal* points, unsigned int pointcount,
                                  unsigned int maxvertices);
ODE_API void dGeomSetConvexHull(dGeomID convex, const dReal* points, unsigned int pointcount,
                                unsigned int maxvertices);

/** Coordinates are in the geom's frame, as dCreateConvex takes them.
    - dGeomConvexGetPoints: Copy up to capacity of the vertices, 3 reals each, m, to points, in the order in
      which they were given. Returns how many vertices there are.
    - dGeomConvexGetPlanes: Copy up to capacity of the planes of the faces, 4 reals each, to planes: the
      unit outward normal n, and n . p of the face's points. Returns how many planes there are.
    - dGeomConvexGetPolygons: Copy up to capacity of the numbers that describe the faces to polygons: for
      each face the number of its corners and their indices among the vertices, counter-clockwise seen from
      outside. Returns how many numbers there are. [ours] */
ODE_API int dGeomConvexGetPoints(dGeomID convex, dReal* points, int capacity);
ODE_API int dGeomConvexGetPlanes(dGeomID convex, dReal* planes, int capacity);
ODE_API int dGeomConvexGetPolygons(dGeomID convex, unsigned int* polygons, int capacity);

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

/** - dGeomTriMeshSetSolid: Make the mesh the solid that its triangles enclose (solid 1) or, as in ODE and
      by default, their surface (0). A convex solid whose centre is inside a solid mesh is pushed out by the
      shortest way, however deep it is. docs/guide/shapes.md tells what other geoms and queries see.
      Refused: other values of solid; 1 for a mesh that is not closed (a triangle without a neighbour over
      an edge, or wound the other way) or that faces inward.
    - dGeomTriMeshGetSolid: 1 if the mesh is a solid now, else 0: data that are not closed make it a surface
      for as long as it has them. [ours] */
ODE_API void dGeomTriMeshSetSolid(dGeomID mesh, int solid);
ODE_API int dGeomTriMeshGetSolid(dGeomID mesh);

/** @chapter field_holes Holes in height fields

    Cells of a height field may be missing: nothing touches what is inside a hole, and rays and queries
    pass. Cell (i, j) lies between the samples (i, j) and (i + 1, j + 1); a field of widthSamples by
    depthSamples samples has widthSamples - 1 by depthSamples - 1 cells, a field that repeats the same in
    every period.

    A field with a hole is no longer solid to any depth: under each triangle the ground is as thick as its
    data's thickness (in m, straight down), with upright walls at the holes; below it is open. Thickness 0
    is a sheet without walls. How bodies meet the walls: docs/guide/shapes.md.

    Arguments:
    - d: the data, built before. Building them again makes a field without holes.
    - i, j: a cell, counted from 0, i along the width and j along the depth.

    Refused: data that are 0, destroyed or not built; cells outside the field; a call from a height
    function; what each function names. Nothing changes then, and the answer is 0. */

/** Removes the cells whose byte is not 0 and restores all others: cell (i, j) is element i + j * widthCells
    of holes, which is copied; 0: no holes. Call it while nothing is collided with the field. widthCells,
    depthCells: the numbers of cells along its width and depth. Refused: other numbers of cells; no memory.
    [ours] */
ODE_API void dGeomHeightfieldDataSetHoles(dHeightfieldDataID d, const unsigned char* holes, int widthCells,
                                          int depthCells);

/** - dGeomHeightfieldDataSetHole: Remove cell (i, j) (hole 1) or restore it (0). Refused: other values of
      hole; no memory.
    - dGeomHeightfieldDataGetHole: 1 if cell (i, j) has been removed, else 0. [ours] */
ODE_API void dGeomHeightfieldDataSetHole(dHeightfieldDataID d, int i, int j, int hole);
ODE_API int dGeomHeightfieldDataGetHole(dHeightfieldDataID d, int i, int j);

#ifdef __cplusplus
}
#endif

#endif
