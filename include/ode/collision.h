/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Collision: shapes ("geoms"), the tests between them, and the collision of spaces.
 *
 * A geom has a shape, a pose in the world (its own or a body's, with an optional offset from it), a
 * bounding box, two sets of bits that filter pairs, and optionally a space it lives in. Collision
 * finds contacts and nothing more; the program turns them into contact joints.
 * Units: metres, radians. The space argument of the create functions is the space to put the geom
 * into, or 0. Planes and spaces have no pose: functions that need one refuse them. */
#ifndef _ODE_COLLISION_H_
#define _ODE_COLLISION_H_

#include <ode/collision_space.h>
#include <ode/common.h>
#include <ode/contact.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter geoms Geoms of all classes

    A new geom: enabled, all category and collide bits set, no body, at the origin, not rotated.

    Arguments:
    - geom: a geom, or (cast) a space.
    - x, y, z: a point, m, world frame.
    - R: a rotation matrix, 12 reals.
    - Q: a quaternion, 4 reals.
    - pos: where 3 reals are written.
    - result: where the answer is written: 3 reals, of a quaternion 4.
    - px, py, pz: a point or direction.

    Refused: a geom that is 0 or destroyed; numbers that are not finite; null pointers; [dGeomSetPosition,
    dGeomSetRotation, dGeomSetQuaternion, dGeomGetPosition, dGeomGetRotation, dGeomGetQuaternion,
    dGeomCopyPosition, dGeomCopyRotation, dGeomSetBody] a geom that has no pose (a plane, a space);
    [dGeomSetPosition, dGeomSetRotation, dGeomSetQuaternion, dGeomSetBody, dGeomDestroy] a member of a space
    that is being collided. Nothing changes then, and getters answer 0. */

/** Destroy the geom; it leaves its space and its body. For a space the same as dSpaceDestroy. [0.16] */
ODE_API void dGeomDestroy(dGeomID geom);

/** - dGeomSetData: Store a pointer of the program's, data, with the geom; NULL at first. The library never
      looks at it.
    - dGeomGetData: The pointer that the program stored with dGeomSetData; NULL if it stored none. [0.16] */
ODE_API void dGeomSetData(dGeomID geom, void* data);
ODE_API void* dGeomGetData(dGeomID geom);

/** - dGeomSetBody: Put the geom on the body, whose pose it then shares (an offset is dropped); 0 takes it
      off its body, and it stays where it is. A geom on a body moves with it, and setting the geom's pose
      moves the body.
    - dGeomGetBody: The body that the geom is on, or 0. [0.16] */
ODE_API void dGeomSetBody(dGeomID geom, dBodyID body);
ODE_API dBodyID dGeomGetBody(dGeomID geom);

/** On a body with an offset the body is moved so that the geom gets there.
    - dGeomSetPosition: Set the geom's position in the world to (x, y, z), m.
    - dGeomSetRotation: Set the geom's rotation in the world to the matrix R, from the geom's frame to the
      world's.
    - dGeomSetQuaternion: Set the geom's rotation in the world to the quaternion Q, of any length but zero.
      [0.16] */
ODE_API void dGeomSetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetQuaternion(dGeomID geom, const dQuaternion Q);

/** The pointer is valid until the geom is changed, moved to another body or destroyed.
    - dGeomGetPosition: A pointer to the geom's position in the world: 3 reals, m.
    - dGeomGetRotation: A pointer to the geom's rotation matrix in the world: 12 reals. [0.16] */
ODE_API const dReal* dGeomGetPosition(dGeomID geom);
ODE_API const dReal* dGeomGetRotation(dGeomID geom);

/** The padding is not written.
    - dGeomCopyPosition: Copy the geom's position in the world, m, to pos.
    - dGeomCopyRotation: Copy the geom's rotation matrix in the world to R: the 9 elements of 12 reals.
    - dGeomGetQuaternion: Write the geom's rotation in the world to result as a quaternion. [0.16] */
ODE_API void dGeomCopyPosition(dGeomID geom, dVector3 pos);
ODE_API void dGeomCopyRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomGetQuaternion(dGeomID geom, dQuaternion result);

/** The bounding box aabb in the world, m: xmin, xmax, ymin, ymax, zmin, zmax. A space gives the box round its
 * members. [0.16] */
ODE_API void dGeomGetAABB(dGeomID geom, dReal aabb[6]);

/** - dGeomIsSpace: 1 if the geom is a space, else 0.
    - dGeomGetSpace: The space that the geom is in, or 0.
    - dGeomGetClass: The number of the geom's class: dSphereClass, dBoxClass and so on; of a class of the
      program's, what dCreateGeomClass returned. [0.16] */
ODE_API int dGeomIsSpace(dGeomID geom);
ODE_API dSpaceID dGeomGetSpace(dGeomID geom);
ODE_API int dGeomGetClass(dGeomID geom);

/** Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    direction.
    - dGeomSetCategoryBits: Set the categories that the geom is in, one bit each; default: all.
    - dGeomSetCollideBits: Set the categories with which the geom collides, one bit each; default: all.
    - dGeomGetCategoryBits: The categories that the geom is in, one bit each.
    - dGeomGetCollideBits: The categories with which the geom collides, one bit each. [0.16] */
ODE_API void dGeomSetCategoryBits(dGeomID geom, unsigned long bits);
ODE_API void dGeomSetCollideBits(dGeomID geom, unsigned long bits);
ODE_API unsigned long dGeomGetCategoryBits(dGeomID geom);
ODE_API unsigned long dGeomGetCollideBits(dGeomID geom);

/** Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    - dGeomEnable: Let spaces find the geom again. New geoms are enabled.
    - dGeomDisable: Let spaces skip the geom until dGeomEnable.
    - dGeomIsEnabled: 1 if spaces find the geom, 0 if they skip it. [0.16] */
ODE_API void dGeomEnable(dGeomID geom);
ODE_API void dGeomDisable(dGeomID geom);
ODE_API int dGeomIsEnabled(dGeomID geom);

/** controlClass of dGeomLowLevelControl. */
enum { dGeomCommonControlClass = 0, dGeomColliderControlClass = 1 };

/** controlCode. */
enum {
    dGeomCommonAnyControlCode = 0,
    dGeomColliderSetMergeSphereContactsControlCode = 1,
    dGeomColliderGetMergeSphereContactsControlCode = 2
};

/** Values of the merge control: how contacts of a sphere with neighbouring triangles are merged. */
enum {
    dGeomColliderMergeContactsValue__Default = 0,
    dGeomColliderMergeContactsValue_None = 1,
    dGeomColliderMergeContactsValue_Normals = 2,
    dGeomColliderMergeContactsValue_Full = 3
};

/** Set or read a setting of the geom's class: controlClass is dGeomCommonControlClass or
    dGeomColliderControlClass, controlCode says which setting. *dataSize is the size of *dataValue. Returns 1
    when done; 0, with the size needed in *dataSize, when size or pointer do not fit; a control the geom does
    not have gives size 0 and 0. Only triangle meshes have controls. [0.16] */
ODE_API int dGeomLowLevelControl(dGeomID geom, int controlClass, int controlCode, void* dataValue,
                                 int* dataSize);

/** A geom without a pose (a plane, a space) gives the input back.
    - dGeomGetRelPointPos: The position in the world of the point (px, py, pz) of the geom's frame, m.
    - dGeomGetPosRelPoint: The coordinates in the geom's frame of the world's point (px, py, pz), m.
    - dGeomVectorToWorld: The direction (px, py, pz) of the geom's frame, turned to the world's axes.
    - dGeomVectorFromWorld: The direction (px, py, pz) of the world, turned to the geom's axes. [0.16] */
ODE_API void dGeomGetRelPointPos(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomGetPosRelPoint(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomVectorToWorld(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomVectorFromWorld(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);

/** @chapter offsets Geoms: offsets from the body

    A geom may sit anywhere on its body.

    Refused: as for geoms; [dGeomSetOffset] a geom that is on no body. */

/** - dGeomSetOffsetPosition: Set the offset's position to (x, y, z), m, in the body's frame; its rotation
      stays.
    - dGeomSetOffsetRotation: Set the offset's rotation to the matrix R, from the geom's frame to the body's;
      its position stays.
    - dGeomSetOffsetQuaternion: Set the offset's rotation to the quaternion Q, of any length but zero, from
      the geom's frame to the body's; its position stays.
    - dGeomSetOffsetWorldPosition: Set the offset's position so that the geom is at the world's point (x, y,
      z), m, now; the body and the offset's rotation stay.
    - dGeomSetOffsetWorldRotation: Set the offset's rotation so that the geom has the rotation matrix R in
      the world now; the body and the offset's position stay.
    - dGeomSetOffsetWorldQuaternion: Set the offset's rotation so that the geom has the rotation Q in the
      world now, a quaternion of any length but zero; the body and the offset's position stay. [0.16] */
ODE_API void dGeomSetOffsetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetOffsetQuaternion(dGeomID geom, const dQuaternion Q);
ODE_API void dGeomSetOffsetWorldPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetWorldRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetOffsetWorldQuaternion(dGeomID geom, const dQuaternion Q);

/** Drop the offset: the geom goes to the body's pose. [0.16] */
ODE_API void dGeomClearOffset(dGeomID geom);

/** 1 when the geom has an offset, else 0. [0.16] */
ODE_API int dGeomIsOffset(dGeomID geom);

/** - dGeomGetOffsetPosition: A pointer to the offset's position in the body's frame, 3 reals, m; zeros if
      there is no offset. Valid until the offset is changed.
    - dGeomCopyOffsetPosition: Copy the offset's position in the body's frame, m, to pos; zeros if there is
      no offset.
    - dGeomGetOffsetRotation: A pointer to the offset's rotation matrix, from the geom's frame to the body's,
      12 reals; the identity if there is no offset. Valid until the offset is changed.
    - dGeomCopyOffsetRotation: Copy the offset's rotation matrix, from the geom's frame to the body's, to R;
      the identity if there is no offset.
    - dGeomGetOffsetQuaternion: Write the offset's rotation, from the geom's frame to the body's, to result
      as a quaternion; the identity if there is no offset. [0.16] */
ODE_API const dReal* dGeomGetOffsetPosition(dGeomID geom);
ODE_API void dGeomCopyOffsetPosition(dGeomID geom, dVector3 pos);
ODE_API const dReal* dGeomGetOffsetRotation(dGeomID geom);
ODE_API void dGeomCopyOffsetRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomGetOffsetQuaternion(dGeomID geom, dQuaternion result);

/** @chapter collide Collision of geoms and spaces

    Refused: an object that is 0, destroyed or of another kind; a null pointer. The answer is then 0. */

/** For dCollide's flags: any contacts will do, so the search may stop when the room is full. */
#define CONTACTS_UNIMPORTANT 0x80000000

/** Contacts of two geoms o1 and o2 (or spaces, whose member pairs are then tested).
    flags: low 16 bits = room in the array, at least 1; and CONTACTS_UNIMPORTANT.
    contact: array whose entries lie `skip` bytes apart, skip >= sizeof(dContactGeom): for an array of
    dContact give &array[0].geom and sizeof(dContact).
    Returns how many entries were written. g1 belongs to o1, g2 to o2; the normal points into g1.
    Two geoms of the same body, or a geom with itself, give 0. Bits, enabling and bounding boxes
    are not looked at. Refused before dInitODE2. [0.16] */
ODE_API int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom* contact, int skip);

/** Call the callback, with data, once for each pair of direct members of the space that are enabled, not on
    the same body, not filtered by their bits, and whose bounding boxes touch. Geoms of zero size are skipped.
    The order of pairs and within a pair is not promised. [0.16] */
ODE_API void dSpaceCollide(dSpaceID space, void* data, dNearCallback* callback);

/** Call the callback, with data, once for each pair of geoms, one of (or in) space1 and one of (or in)
    space2, in this order, that are enabled, not on the same body, not filtered by their bits, and whose
    bounding boxes touch. Of two spaces with different sublevels the higher one is opened and the other passed
    whole; with equal sublevels both are opened; the same space twice is dSpaceCollide. [0.16] */
ODE_API void dSpaceCollide2(dGeomID space1, dGeomID space2, void* data, dNearCallback* callback);

/** @chapter shapes Shapes

    Sizes must not be negative; 0 is allowed and makes the geom invisible to spaces. Changing a size does not
    change the mass of a body. The PointDepth functions tell how deep the world point (x, y, z) is inside:
    positive inside, 0 on the surface, negative outside, m.

    Arguments:
    - space: the space to put a new geom into, or 0.
    - radius, length: m; of a capsule, length is that of the cylindrical part. Getters write them where
    pointers point.
    - lx, ly, lz: full side lengths, m.
    - a, b, c, d: numbers of a plane a x + b y + c z = d.
    - sphere, box, plane, capsule, cylinder, ray: a geom of that class.
    - x, y, z: a point of the world, m.
    - result: where the answer is written, in the order of the setter's arguments: 3 reals, of a plane 4.

    Refused: a geom of another class, destroyed or 0; a space that is destroyed or being collided;
    [dCreateSphere, dGeomSphereSet, dCreateBox, dGeomBoxSet, dCreateCapsule, dGeomCapsuleSet,
    dCreateCylinder, dGeomCylinderSet, dCreateRay, dGeomRaySetLength] a negative size; [!dCreateRay,
    !dGeomRaySetLength] a number that is not finite; [dCreateRay, dGeomRaySetLength] NaN; a null pointer.
    Nothing changes then, and the answer is 0. */

/** How many classes a program can add. */
enum { dMaxUserClasses = 4 };

/** What dGeomGetClass answers. */
enum {
    dSphereClass = 0,
    dBoxClass,
    dCapsuleClass,
    dCylinderClass,
    dPlaneClass,
    dRayClass,
    dConvexClass,
    dGeomTransformClass,
    dTriMeshClass,
    dHeightfieldClass,

    dFirstSpaceClass,
    dSimpleSpaceClass = dFirstSpaceClass,
    dHashSpaceClass,
    dSweepAndPruneSpaceClass,
    dQuadTreeSpaceClass,
    dLastSpaceClass = dQuadTreeSpaceClass,

    dFirstUserClass,
    dLastUserClass = dFirstUserClass + dMaxUserClasses - 1,
    dGeomNumClasses
};

/** - dCreateSphere: A new sphere of this radius, m, in the space, or (0) in none.
    - dGeomSphereSetRadius: Set the sphere's radius, m.
    - dGeomSphereGetRadius: The sphere's radius, m.
    - dGeomSpherePointDepth: How deep the world's point (x, y, z) is inside the sphere, m: positive inside, 0
      on the surface, negative outside. [0.16] */
ODE_API dGeomID dCreateSphere(dSpaceID space, dReal radius);
ODE_API void dGeomSphereSetRadius(dGeomID sphere, dReal radius);
ODE_API dReal dGeomSphereGetRadius(dGeomID sphere);
ODE_API dReal dGeomSpherePointDepth(dGeomID sphere, dReal x, dReal y, dReal z);

/** The solid is the hull of the points, in the geom's frame; the arrays are copied. Faces are found from the
    points, so that missing or inverted ones do no harm. Refused: no plane; fewer than 3 points; all points in
    a line (points of a plane make a plate); planes and polygons that are not numbers and indices of points.
    - points: pointcount points, 3 reals each, m.
    - polygons: for each of the planecount faces its number of corners and their indices, counter-clockwise.
    - planes: for each face its unit outward normal n and n . p of its points p, 4 reals.
    - dCreateConvex: A new convex polyhedron in the space, or (0) in none.
    - dGeomSetConvex: Give the geom convex another polyhedron, or the same arrays with other numbers. [0.16] */
ODE_API dGeomID dCreateConvex(dSpaceID space, const dReal* planes, unsigned int planecount,
                              const dReal* points, unsigned int pointcount, const unsigned int* polygons);
ODE_API void dGeomSetConvex(dGeomID convex, const dReal* planes, unsigned int planecount, const dReal* points,
                            unsigned int pointcount, const unsigned int* polygons);

/** - dCreateBox: A new box in the space, or (0) in none, centred, with the full side lengths lx, ly, lz
      along its own axes, m.
    - dGeomBoxSetLengths: Set the box's full side lengths to lx, ly, lz, m.
    - dGeomBoxGetLengths: Write the box's full side lengths to result: 3 reals, m. [0.16] */
ODE_API dGeomID dCreateBox(dSpaceID space, dReal lx, dReal ly, dReal lz);
ODE_API void dGeomBoxSetLengths(dGeomID box, dReal lx, dReal ly, dReal lz);
ODE_API void dGeomBoxGetLengths(dGeomID box, dVector3 result);

/** How deep a point is inside the box: the distance to the nearest face, negative outside. [0.16] */
ODE_API dReal dGeomBoxPointDepth(dGeomID box, dReal x, dReal y, dReal z);

/** - dCreatePlane: A new plane in the space, or (0) in none: the solid half-space a x + b y + c z <= d of
      the world. (a, b, c) is the outward normal; the four numbers are divided by its length, and a zero
      normal becomes (1, 0, 0) with d = 0. A plane has no pose and is on no body.
    - dGeomPlaneSetParams: Set the plane to the half-space a x + b y + c z <= d of the world; the four
      numbers are divided by the length of the outward normal (a, b, c), and a zero normal becomes (1, 0, 0)
      with d = 0.
    - dGeomPlaneGetParams: Write the plane's unit outward normal and its distance from the origin along it,
      m, to result: 4 reals.
    - dGeomPlanePointDepth: How deep the world's point (x, y, z) is below the plane's surface, m: positive
      inside the solid half-space, 0 on the surface, negative outside. [0.16] */
ODE_API dGeomID dCreatePlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d);
ODE_API void dGeomPlaneSetParams(dGeomID plane, dReal a, dReal b, dReal c, dReal d);
ODE_API void dGeomPlaneGetParams(dGeomID plane, dVector4 result);
ODE_API dReal dGeomPlanePointDepth(dGeomID plane, dReal x, dReal y, dReal z);

/** The length leaves out the round caps.
    - dCreateCapsule: A new capsule in the space, or (0) in none: a cylinder of radius and length, m, along
      its own z axis, with round caps.
    - dGeomCapsuleSetParams: Set the capsule's radius and length, m.
    - dGeomCapsuleGetParams: Write the capsule's radius to *radius and its length to *length, m.
    - dGeomCapsulePointDepth: How deep the world's point (x, y, z) is inside the capsule, m: positive inside,
      0 on the surface, negative outside. [0.16] */
ODE_API dGeomID dCreateCapsule(dSpaceID space, dReal radius, dReal length);
ODE_API void dGeomCapsuleSetParams(dGeomID capsule, dReal radius, dReal length);
ODE_API void dGeomCapsuleGetParams(dGeomID capsule, dReal* radius, dReal* length);
ODE_API dReal dGeomCapsulePointDepth(dGeomID capsule, dReal x, dReal y, dReal z);

/** The capsule's old name. */
#define dCreateCCylinder dCreateCapsule
#define dGeomCCylinderSetParams dGeomCapsuleSetParams
#define dGeomCCylinderGetParams dGeomCapsuleGetParams
#define dGeomCCylinderPointDepth dGeomCapsulePointDepth
#define dCCylinderClass dCapsuleClass

/** - dCreateCylinder: A new cylinder with flat ends in the space, or (0) in none, of radius and length, m,
      along its own z axis.
    - dGeomCylinderSetParams: Set the cylinder's radius and length, m.
    - dGeomCylinderGetParams: Write the cylinder's radius to *radius and its length to *length, m. [0.16] */
ODE_API dGeomID dCreateCylinder(dSpaceID space, dReal radius, dReal length);
ODE_API void dGeomCylinderSetParams(dGeomID cylinder, dReal radius, dReal length);
ODE_API void dGeomCylinderGetParams(dGeomID cylinder, dReal* radius, dReal* length);

/** - dCreateRay: A new ray of this length, m (it may be infinite), in the space, or (0) in none. It goes from
    its position along its own z axis. A contact of a ray has its `pos` where it hits, as depth the distance
    from its start, as normal the surface normal that faces the start. It has at most one contact with a simple
    shape.
    - dGeomRaySetLength: Set the ray's length, m; it may be infinite.
    - dGeomRayGetLength: The ray's length, m. [0.16] */
ODE_API dGeomID dCreateRay(dSpaceID space, dReal length);
ODE_API void dGeomRaySetLength(dGeomID ray, dReal length);
ODE_API dReal dGeomRayGetLength(dGeomID ray);

/** - dGeomRaySet: Set the ray's start to (px, py, pz), m, and its direction to (dx, dy, dz), which is
      normalised here and must not be zero; both in the world's frame.
    - dGeomRayGet: Write where the ray starts, m, to start, and its direction, a unit vector, to dir: 3 reals
      each, world frame. [0.16] */
ODE_API void dGeomRaySet(dGeomID ray, dReal px, dReal py, dReal pz, dReal dx, dReal dy, dReal dz);
ODE_API void dGeomRayGet(dGeomID ray, dVector3 start, dVector3 dir);

/** - dGeomRaySetParams: Old form of two calls: dGeomRaySetFirstContact with FirstContact and
      dGeomRaySetBackfaceCull with BackfaceCull.
    - dGeomRayGetParams: Old form of two calls: write what dGeomRayGetFirstContact answers to *FirstContact
      and what dGeomRayGetBackfaceCull answers to *BackfaceCull.
    - dGeomRaySetFirstContact: Let the ray take the first hit that is found on a shape with many
      (firstContact not 0) instead of looking for more; default 0.
    - dGeomRayGetFirstContact: Whether the ray takes the first hit that is found: 1 or 0.
    - dGeomRaySetBackfaceCull: Let the ray ignore faces that it meets from behind (backfaceCull not 0);
      default 0.
    - dGeomRayGetBackfaceCull: Whether the ray ignores faces that it meets from behind: 1 or 0.
    - dGeomRaySetClosestHit: Let the ray give only the closest of the hits on a shape with many (closestHit
      not 0); default 0.
    - dGeomRayGetClosestHit: Whether the ray gives only the closest hit: 1 or 0. [0.16] */
ODE_API_DEPRECATED ODE_API void dGeomRaySetParams(dGeomID ray, int FirstContact, int BackfaceCull);
ODE_API_DEPRECATED ODE_API void dGeomRayGetParams(dGeomID ray, int* FirstContact, int* BackfaceCull);
ODE_API void dGeomRaySetFirstContact(dGeomID ray, int firstContact);
ODE_API int dGeomRayGetFirstContact(dGeomID ray);
ODE_API void dGeomRaySetBackfaceCull(dGeomID ray, int backfaceCull);
ODE_API int dGeomRayGetBackfaceCull(dGeomID ray);
ODE_API void dGeomRaySetClosestHit(dGeomID ray, int closestHit);
ODE_API int dGeomRayGetClosestHit(dGeomID ray);

#include "collision_trimesh.h"

/** A geom transform, in a space or (0) in none: an old way to place a geom relative to a body. Use offsets
    instead. [0.16] */
ODE_API_DEPRECATED ODE_API dGeomID dCreateGeomTransform(dSpaceID space);

/** - dGeomTransformSetGeom: Put the geom obj inside the transform, relative to which it is placed; 0: none.
      It must be in no space and on no body.
    - dGeomTransformGetGeom: The geom inside the transform, or 0. [0.16] */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetGeom(dGeomID transform, dGeomID obj);
ODE_API_DEPRECATED ODE_API dGeomID dGeomTransformGetGeom(dGeomID transform);

/** - dGeomTransformSetCleanup: Say whether (mode not 0) the geom inside is destroyed with the transform and
      when it is replaced; default 0.
    - dGeomTransformGetCleanup: The mode that dGeomTransformSetCleanup has set, 0 at first. [0.16] */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetCleanup(dGeomID transform, int mode);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetCleanup(dGeomID transform);

/** - dGeomTransformSetInfo: Say whether contacts name the transform (mode 1) or the geom inside (0, the
      default).
    - dGeomTransformGetInfo: The mode that dGeomTransformSetInfo has set, 0 at first. [0.16] */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetInfo(dGeomID transform, int mode);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetInfo(dGeomID transform);

struct dxHeightfieldData;
typedef struct dxHeightfieldData* dHeightfieldDataID; /**< the heights of height fields */

/** The sample (x, z); it counts as 0 when it is no number. Must not change while a collision goes on. */
typedef dReal dHeightfieldGetHeight(void* p_user_data, int x, int z);

/** @chapter heightfields Height fields

    Ground given by heights over a rectangle, solid to any depth (ext.h has holes). In the geom's own frame y
    is up, x runs along the width and z along the depth, and the origin is the middle of the rectangle. Sample
    (i, j), with i along x, is element i + j * widthSamples; its height is sample * scale + offset. Each cell
    is two triangles, divided from the corner (i + 1, j) to the corner (i, j + 1). For z up rotate the geom by
    90 degrees about x. Collides with spheres, boxes, capsules, cylinders and rays; normals point up out of the
    ground. A solid wholly below the lowest sample under it gets one contact that pushes it straight up. A ray
    gets all its hits, the nearest first. Of a solid that covers more than 1,024 cells along x or z (256 of a
    field without end) the middle ones are looked at.

    Arguments:
    - d: the data.
    - pUserData: handed to the callback.
    - pCallback: gives a sample.
    - pHeightData: widthSamples * depthSamples samples.
    - scale, offset: height = sample * scale + offset, m.

    Refused: data or a geom that is 0 or destroyed; [dGeomHeightfieldDataBuild] sizes that are not positive;
    [dGeomHeightfieldDataBuild] fewer than 2 samples along a side; numbers that are not finite; null
    pointers. Nothing changes then, and the answer is 0. */

/** - dGeomHeightfieldDataCreate: New data for the heights of one or more geoms, empty at first.
    - dGeomHeightfieldDataDestroy: Destroy the data; do so after their geoms. A geom whose data are gone
      collides with nothing. [0.16] */
ODE_API dHeightfieldDataID dGeomHeightfieldDataCreate(void);
ODE_API void dGeomHeightfieldDataDestroy(dHeightfieldDataID d);

/** width, depth > 0: sides of the rectangle, m; widthSamples, depthSamples >= 2: samples along them.
    thickness >= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    already get their new box when they move or are given the data again.
    - dGeomHeightfieldDataBuildCallback: Take the heights from the function pCallback, which is called with
      pUserData whenever a sample is needed.
    - dGeomHeightfieldDataBuildByte: Take the heights from the bytes at pHeightData. bCopyHeightData 0: the
      program keeps the array alive.
    - dGeomHeightfieldDataBuildShort: Take the heights from the short integers at pHeightData.
      bCopyHeightData 0: the program keeps the array alive.
    - dGeomHeightfieldDataBuildSingle: Take the heights from the floats at pHeightData. bCopyHeightData 0:
      the program keeps the array alive.
    - dGeomHeightfieldDataBuildDouble: Take the heights from the doubles at pHeightData. bCopyHeightData 0:
      the program keeps the array alive. [0.16] */
ODE_API void dGeomHeightfieldDataBuildCallback(dHeightfieldDataID d, void* pUserData,
                                               dHeightfieldGetHeight* pCallback, dReal width, dReal depth,
                                               int widthSamples, int depthSamples, dReal scale, dReal offset,
                                               dReal thickness, int bWrap);
ODE_API void dGeomHeightfieldDataBuildByte(dHeightfieldDataID d, const unsigned char* pHeightData,
                                           int bCopyHeightData, dReal width, dReal depth, int widthSamples,
                                           int depthSamples, dReal scale, dReal offset, dReal thickness,
                                           int bWrap);
ODE_API void dGeomHeightfieldDataBuildShort(dHeightfieldDataID d, const short* pHeightData,
                                            int bCopyHeightData, dReal width, dReal depth, int widthSamples,
                                            int depthSamples, dReal scale, dReal offset, dReal thickness,
                                            int bWrap);
ODE_API void dGeomHeightfieldDataBuildSingle(dHeightfieldDataID d, const float* pHeightData,
                                             int bCopyHeightData, dReal width, dReal depth, int widthSamples,
                                             int depthSamples, dReal scale, dReal offset, dReal thickness,
                                             int bWrap);
ODE_API void dGeomHeightfieldDataBuildDouble(dHeightfieldDataID d, const double* pHeightData,
                                             int bCopyHeightData, dReal width, dReal depth, int widthSamples,
                                             int depthSamples, dReal scale, dReal offset, dReal thickness,
                                             int bWrap);

/** The range minHeight ... maxHeight of samples (before scale and offset) that the bounding box is made of.
    Arrays know theirs; a callback's field has an infinite box until this is called. [0.16] */
ODE_API void dGeomHeightfieldDataSetBounds(dHeightfieldDataID d, dReal minHeight, dReal maxHeight);

/** - dCreateHeightfield: A new height field in the space, or (0) in none, over data, which may be 0 for now.
      bPlaceable 0: it stays at the origin, not rotated.
    - dGeomHeightfieldSetHeightfieldData: Give the height field g other heights: the data d.
    - dGeomHeightfieldGetHeightfieldData: The data of the height field g, or 0. [0.16] */
ODE_API dGeomID dCreateHeightfield(dSpaceID space, dHeightfieldDataID data, int bPlaceable);
ODE_API void dGeomHeightfieldSetHeightfieldData(dGeomID g, dHeightfieldDataID d);
ODE_API dHeightfieldDataID dGeomHeightfieldGetHeightfieldData(dGeomID g);

/** @chapter collision_helpers Collision: helpers

    Refused: null pointers; numbers that are not finite. Nothing is written then, and the answer is 0. */

/** The closest points cp1 and cp2 (3 reals each) of the segments a1-a2 and b1-b2; of parallel segments one
    pair of them. [0.16] */
ODE_API void dClosestLineSegmentPoints(const dVector3 a1, const dVector3 a2, const dVector3 b1,
                                       const dVector3 b2, dVector3 cp1, dVector3 cp2);

/** 1 when two boxes touch or overlap, else 0. Their centres are _p1 and _p2 (m), their rotation matrices R1
    and R2, their full side lengths side1 and side2 (3 reals each). [0.16] */
ODE_API int dBoxTouchesBox(const dVector3 _p1, const dMatrix3 R1, const dVector3 side1, const dVector3 _p2,
                           const dMatrix3 R2, const dVector3 side2);

/** Contacts of two boxes with centres p1, p2, rotation matrices R1, R2 and full side lengths side1, side2.
    Written: normal (from box 1 to box 2), the greatest depth (how far they must move apart along that normal),
    *return_code (1-3 face of box 1, 4-6 face of box 2, 7-15 a pair of edges), and `pos` and `depth` of as many
    entries of contact as fit (flags and skip as for dCollide). Returns their number, 0 when the boxes are
    apart. [0.16] */
ODE_API int dBoxBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2,
                    const dMatrix3 R2, const dVector3 side2, dVector3 normal, dReal* depth, int* return_code,
                    int flags, dContactGeom* contact, int skip);

/** A bounding box without bounds, written to aabb whatever the geom is: an aabb function for user classes.
 * [0.16] */
ODE_API void dInfiniteAABB(dGeomID geom, dReal aabb[6]);

/** @chapter user_classes Classes of the program's own

    Refused: as each function says. */

/** Writes the bounding box of a geom; its pose is up to date. */
typedef void dGetAABBFn(dGeomID geom, dReal aabb[6]);

/** Finds contacts of o1 (of the class the function belongs to) and o2, as dCollide. */
typedef int dColliderFn(dGeomID o1, dGeomID o2, int flags, dContactGeom* contact, int skip);

/** Gives the function that collides the user class with class num, or 0. Asked once per class. */
typedef dColliderFn* dGetColliderFnFn(int num);

/** Called when a geom of the class is destroyed, before its data goes. */
typedef void dGeomDtorFn(dGeomID o);

/** May o1 touch anything inside o2's bounding box? 0 saves the closer test. */
typedef int dAABBTestFn(dGeomID o1, dGeomID o2, dReal aabb[6]);

/** A class of the program's own. collider and aabb must be given, the other functions may be 0. */
typedef struct dGeomClass {
    int bytes;                  /**< size of the class's data in each geom */
    dGetColliderFnFn* collider; /**< gives the functions that find contacts */
    dGetAABBFn* aabb;           /**< computes the bounding box */
    dAABBTestFn* aabb_test;     /**< saves closer tests, or 0 */
    dGeomDtorFn* dtor;          /**< called when a geom is destroyed, or 0 */
} dGeomClass;

/** Register the class that *classptr describes; returns its number, dFirstUserClass and up. Refused (-1) when
    the description is bad or dMaxUserClasses are taken. dCloseODE forgets the classes. [0.16] */
ODE_API int dCreateGeomClass(const dGeomClass* classptr);

/** The data of geom, of a user class: `bytes` bytes, zero at first. A geom of another class is refused: 0.
 * [0.16] */
ODE_API void* dGeomGetClassData(dGeomID geom);

/** A geom of the user class classnum, in no space. A number that is none is refused: 0. [0.16] */
ODE_API dGeomID dCreateGeom(int classnum);

/** Collide classes i and j with the function fn from now on (and j with i by turning it round); 0
    lets the pair not collide at all. Process-wide, until dCloseODE. Numbers that are no
    class are refused, and all calls while the library is not open. [0.16] */
ODE_API void dSetColliderOverride(int i, int j, dColliderFn* fn);

#ifdef __cplusplus
}
#endif

#endif
