// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Collision: shapes ("geoms"), the tests between them, and the collision of spaces.
//
// A geom has a shape, a pose in the world (its own or a body's, with an optional offset from it), a
// bounding box, two sets of bits that filter pairs, and optionally a space it lives in. Collision
// finds contacts and nothing more; the program turns them into contact joints.
// Units: metres, radians. The space argument of the create functions is the space to put the geom
// into, or 0. Planes and spaces have no pose: functions that need one refuse them.
#ifndef _ODE_COLLISION_H_
#define _ODE_COLLISION_H_

#include <ode/collision_space.h>
#include <ode/common.h>
#include <ode/contact.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ======================================================================== geoms, all kinds

   A new geom: enabled, all category and collide bits set, no body, at the origin, not rotated. */

/** Destroy a geom; it leaves its space and its body. For a space the same as dSpaceDestroy. */
ODE_API void dGeomDestroy(dGeomID geom);

/** A pointer of the program's, NULL at first. */
ODE_API void dGeomSetData(dGeomID geom, void* data);
ODE_API void* dGeomGetData(dGeomID geom);

/** Put the geom on a body, whose pose it then shares (an offset is dropped); 0 takes it off, and it stays
   where it is. A geom on a body moves with it, and setting the geom's pose moves the body. */
ODE_API void dGeomSetBody(dGeomID geom, dBodyID body);
ODE_API dBodyID dGeomGetBody(dGeomID geom);

/** The pose in the world. On a body with an offset the body is moved so that the geom gets there. */
ODE_API void dGeomSetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetQuaternion(dGeomID geom, const dQuaternion Q);

/** Pointers to 3 (4) and 12 reals; valid until the geom is changed, moved to another body or
    destroyed. */
ODE_API const dReal* dGeomGetPosition(dGeomID geom);
ODE_API const dReal* dGeomGetRotation(dGeomID geom);

/** Copies; the padding is not written. */
ODE_API void dGeomCopyPosition(dGeomID geom, dVector3 pos);
ODE_API void dGeomCopyRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomGetQuaternion(dGeomID geom, dQuaternion result);

/** The bounding box: xmin, xmax, ymin, ymax, zmin, zmax. A space gives the box round its members. */
ODE_API void dGeomGetAABB(dGeomID geom, dReal aabb[6]);

/** 1 for a space, else 0; the space the geom is in, or 0; its class number. */
ODE_API int dGeomIsSpace(dGeomID geom);
ODE_API dSpaceID dGeomGetSpace(dGeomID geom);
ODE_API int dGeomGetClass(dGeomID geom);

/** Filter of pairs: spaces report two geoms when the category bits of one meet the collide bits of
    the other, in at least one direction. */
ODE_API void dGeomSetCategoryBits(dGeomID geom, unsigned long bits);
ODE_API void dGeomSetCollideBits(dGeomID geom, unsigned long bits);
ODE_API unsigned long dGeomGetCategoryBits(dGeomID geom);
ODE_API unsigned long dGeomGetCollideBits(dGeomID geom);

/** Spaces skip disabled geoms; dCollide does not. Independent of the body's state. */
ODE_API void dGeomEnable(dGeomID geom);
ODE_API void dGeomDisable(dGeomID geom);
ODE_API int dGeomIsEnabled(dGeomID geom);

/* ---- low-level control ---- */

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

/** Settings of single classes. *dataSize is the size of *dataValue. Returns 1 when done; 0, with the size
   needed in *dataSize, when size or pointer do not fit; a control the geom does not have gives size 0 and 0.
   Only triangle meshes have controls. */
ODE_API int dGeomLowLevelControl(dGeomID geom, int controlClass, int controlCode, void* dataValue,
                                 int* dataSize);

/* ---- points and vectors: as the functions of bodies. Geoms without a pose give the input back. ---- */

ODE_API void dGeomGetRelPointPos(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomGetPosRelPoint(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomVectorToWorld(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);
ODE_API void dGeomVectorFromWorld(dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result);

/* ---- offsets from the body ----
   Setting needs a geom on a body. The first group is in the body's frame; the World forms say
   where the geom is to be now and leave the body alone. Setting one part keeps the other. */

ODE_API void dGeomSetOffsetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetOffsetQuaternion(dGeomID geom, const dQuaternion Q);
ODE_API void dGeomSetOffsetWorldPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetWorldRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetOffsetWorldQuaternion(dGeomID geom, const dQuaternion Q);

/** Drop the offset: the geom goes to the body's pose. */
ODE_API void dGeomClearOffset(dGeomID geom);
ODE_API int dGeomIsOffset(dGeomID geom);

/** The offset in the body's frame; zero and identity when there is none. */
ODE_API const dReal* dGeomGetOffsetPosition(dGeomID geom);
ODE_API void dGeomCopyOffsetPosition(dGeomID geom, dVector3 pos);
ODE_API const dReal* dGeomGetOffsetRotation(dGeomID geom);
ODE_API void dGeomCopyOffsetRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomGetOffsetQuaternion(dGeomID geom, dQuaternion result);

/* ======================================================================== collision */

/** For dCollide's flags: any contacts will do, so the search may stop when the room is full. */
#define CONTACTS_UNIMPORTANT 0x80000000

/** Contacts of two geoms (or spaces, whose member pairs are then tested).
    flags: low 16 bits = room in the array, at least 1; and CONTACTS_UNIMPORTANT.
    contact: array whose entries lie `skip` bytes apart, skip >= sizeof(dContactGeom): for an array of
    dContact give &array[0].geom and sizeof(dContact).
    Returns how many entries were written. g1 belongs to o1, g2 to o2; the normal points into g1.
    Two geoms of the same body, or a geom with itself, give 0. Bits, enabling and bounding boxes
    are not looked at. Refused before dInitODE2. */
ODE_API int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom* contact, int skip);

/** Call the callback once for each pair of direct members of the space that are enabled, not on the same
   body, not filtered by their bits, and whose bounding boxes touch. Geoms of zero size are skipped. The order
   of pairs and within a pair is not promised. */
ODE_API void dSpaceCollide(dSpaceID space, void* data, dNearCallback* callback);

/** The same between two geoms or spaces: each pair has one from the first and one from the second
    argument, in this order. Of two spaces with different sublevels the higher one is opened and the
    other passed whole; with equal sublevels both are opened; the same space twice is dSpaceCollide. */
ODE_API void dSpaceCollide2(dGeomID space1, dGeomID space2, void* data, dNearCallback* callback);

/* ======================================================================== classes */

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

/* Sizes below must not be negative; 0 is allowed and makes the geom invisible to spaces. Changing a
   size does not change the mass of a body. The PointDepth functions tell how deep the world point (x, y, z)
   is inside: positive inside, 0 on the surface, negative outside. */

/* ---- sphere ---- */

ODE_API dGeomID dCreateSphere(dSpaceID space, dReal radius);
ODE_API void dGeomSphereSetRadius(dGeomID sphere, dReal radius);
ODE_API dReal dGeomSphereGetRadius(dGeomID sphere);
ODE_API dReal dGeomSpherePointDepth(dGeomID sphere, dReal x, dReal y, dReal z);

/* ---- box: full side lengths along its own axes, centred ---- */

ODE_API dGeomID dCreateBox(dSpaceID space, dReal lx, dReal ly, dReal lz);
ODE_API void dGeomBoxSetLengths(dGeomID box, dReal lx, dReal ly, dReal lz);
ODE_API void dGeomBoxGetLengths(dGeomID box, dVector3 result);

/** Of a point outside only the sign is meaningful. */
ODE_API dReal dGeomBoxPointDepth(dGeomID box, dReal x, dReal y, dReal z);

/* ---- plane: the solid half-space a x + b y + c z <= d, in world coordinates ---- */

/** (a, b, c) is the outward normal; the four numbers are divided by its length. A zero normal becomes
    (1, 0, 0) with d = 0. */
ODE_API dGeomID dCreatePlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d);
ODE_API void dGeomPlaneSetParams(dGeomID plane, dReal a, dReal b, dReal c, dReal d);
ODE_API void dGeomPlaneGetParams(dGeomID plane, dVector4 result);
ODE_API dReal dGeomPlanePointDepth(dGeomID plane, dReal x, dReal y, dReal z);

/* ---- capsule: a cylinder along its own z axis with round caps; length without the caps ---- */

ODE_API dGeomID dCreateCapsule(dSpaceID space, dReal radius, dReal length);
ODE_API void dGeomCapsuleSetParams(dGeomID capsule, dReal radius, dReal length);
ODE_API void dGeomCapsuleGetParams(dGeomID capsule, dReal* radius, dReal* length);
ODE_API dReal dGeomCapsulePointDepth(dGeomID capsule, dReal x, dReal y, dReal z);

/* The capsule's old name. */
#define dCreateCCylinder dCreateCapsule
#define dGeomCCylinderSetParams dGeomCapsuleSetParams
#define dGeomCCylinderGetParams dGeomCapsuleGetParams
#define dGeomCCylinderPointDepth dGeomCapsulePointDepth
#define dCCylinderClass dCapsuleClass

/* ---- cylinder: along its own z axis, flat ends ---- */

ODE_API dGeomID dCreateCylinder(dSpaceID space, dReal radius, dReal length);
ODE_API void dGeomCylinderSetParams(dGeomID cylinder, dReal radius, dReal length);
ODE_API void dGeomCylinderGetParams(dGeomID cylinder, dReal* radius, dReal* length);

/* ---- ray: from its position along its own z axis ----
   A contact of a ray: pos = where it hits, depth = distance from its start, normal = surface normal
   that faces the start. At most one contact with a simple shape. */

ODE_API dGeomID dCreateRay(dSpaceID space, dReal length);
ODE_API void dGeomRaySetLength(dGeomID ray, dReal length);
ODE_API dReal dGeomRayGetLength(dGeomID ray);

/** Start p and direction d (normalised here; zero is refused). The getter gives a unit vector. */
ODE_API void dGeomRaySet(dGeomID ray, dReal px, dReal py, dReal pz, dReal dx, dReal dy, dReal dz);
ODE_API void dGeomRayGet(dGeomID ray, dVector3 start, dVector3 dir);

/** Flags for shapes with many hits, all 0 by default: take the first one found; ignore faces seen from
   behind; give the closest hit only. The first two functions are the old form of the first two flags. */
ODE_API_DEPRECATED ODE_API void dGeomRaySetParams(dGeomID ray, int FirstContact, int BackfaceCull);
ODE_API_DEPRECATED ODE_API void dGeomRayGetParams(dGeomID ray, int* FirstContact, int* BackfaceCull);
ODE_API void dGeomRaySetFirstContact(dGeomID ray, int firstContact);
ODE_API int dGeomRayGetFirstContact(dGeomID ray);
ODE_API void dGeomRaySetBackfaceCull(dGeomID ray, int backfaceCull);
ODE_API int dGeomRayGetBackfaceCull(dGeomID ray);
ODE_API void dGeomRaySetClosestHit(dGeomID ray, int closestHit);
ODE_API int dGeomRayGetClosestHit(dGeomID ray);

#include "collision_trimesh.h"

/* ---- geom transform: an old way to place a geom relative to a body; use offsets instead ---- */

ODE_API_DEPRECATED ODE_API dGeomID dCreateGeomTransform(dSpaceID space);

/** The geom inside, placed relative to the transform. It must be in no space and on no body. 0: none. */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetGeom(dGeomID transform, dGeomID obj);
ODE_API_DEPRECATED ODE_API dGeomID dGeomTransformGetGeom(dGeomID transform);

/** Whether the geom inside is destroyed with the transform or when it is replaced, default 0. */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetCleanup(dGeomID transform, int mode);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetCleanup(dGeomID transform);

/** Whether contacts name the transform (1) or the geom inside (0, default). */
ODE_API_DEPRECATED ODE_API void dGeomTransformSetInfo(dGeomID transform, int mode);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetInfo(dGeomID transform);

struct dxHeightfieldData;
typedef struct dxHeightfieldData* dHeightfieldDataID;

/** The sample (x, z); it counts as 0 when it is no number. Must not change while a collision goes on. */
typedef dReal dHeightfieldGetHeight(void* p_user_data, int x, int z);

/* ---- height fields ----
   Ground given by heights over a rectangle, solid to any depth. In the geom's own frame y is up, x runs along
   the width and z along the depth, and the origin is the middle of the rectangle. Sample (i, j), with i along
   x, is element i + j * widthSamples; its height is sample * scale + offset. Each cell is two triangles,
   divided from the corner (i + 1, j) to the corner (i, j + 1). For z up rotate the geom by 90 degrees about
   x. Collides with spheres, boxes, capsules, cylinders and rays; normals point up out of the ground. A solid
   wholly below the lowest sample under it gets one contact that pushes it straight up. A ray gets all its
   hits, the nearest first. */

/** The heights of one or more geoms. Destroy it after them; a geom whose data are gone collides with nothing.
 */
ODE_API dHeightfieldDataID dGeomHeightfieldDataCreate(void);
ODE_API void dGeomHeightfieldDataDestroy(dHeightfieldDataID d);

/** Set the heights from an array of a type, or by calling a function whenever one is needed.
    bCopyHeightData: 0 means that the program keeps the array alive. width, depth > 0: sides of the rectangle;
    widthSamples, depthSamples >= 2: samples along them. thickness >= 0 lowers the bounding box's bottom, so
   that spaces still report what has sunk that far. bWrap: the field repeats without end along x and z (then
   the last column and row stand for the first, and the bounding box is infinite). Heights that are no usable
   numbers are refused and nothing changes. Geoms that use the data already get their new box when they move
   or are given the data again. */
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

/** The range of samples (before scale and offset) that the bounding box is made of. Arrays know theirs; a
    callback's field has an infinite box until this is called. */
ODE_API void dGeomHeightfieldDataSetBounds(dHeightfieldDataID d, dReal minHeight, dReal maxHeight);

/** A field in the world: bPlaceable 0 for one that stays at the origin, not rotated. data may be 0 for now.
 */
ODE_API dGeomID dCreateHeightfield(dSpaceID space, dHeightfieldDataID data, int bPlaceable);
ODE_API void dGeomHeightfieldSetHeightfieldData(dGeomID g, dHeightfieldDataID d);
ODE_API dHeightfieldDataID dGeomHeightfieldGetHeightfieldData(dGeomID g);

/* ======================================================================== helpers */

/** The closest points cp1 and cp2 of the segments a1-a2 and b1-b2; of parallel segments one pair of
    them. */
ODE_API void dClosestLineSegmentPoints(const dVector3 a1, const dVector3 a2, const dVector3 b1,
                                       const dVector3 b2, dVector3 cp1, dVector3 cp2);

/** 1 when two boxes (centre p, rotation R, full sides) touch or overlap, else 0. */
ODE_API int dBoxTouchesBox(const dVector3 _p1, const dMatrix3 R1, const dVector3 side1, const dVector3 _p2,
                           const dMatrix3 R2, const dVector3 side2);

/** Contacts of two boxes. Written: normal (from box 1 to box 2), the greatest depth, *return_code (1-3 face
   of box 1, 4-6 face of box 2, 7-15 a pair of edges), and pos and depth of as many contacts as fit (flags and
   skip as for dCollide). Returns their number, 0 when the boxes are apart. */
ODE_API int dBoxBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2,
                    const dMatrix3 R2, const dVector3 side2, dVector3 normal, dReal* depth, int* return_code,
                    int flags, dContactGeom* contact, int skip);

/** A bounding box without bounds: an aabb function for user classes. */
ODE_API void dInfiniteAABB(dGeomID geom, dReal aabb[6]);

/* ======================================================================== user classes */

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
    int bytes; /**< size of the class's data in each geom */
    dGetColliderFnFn* collider;
    dGetAABBFn* aabb;
    dAABBTestFn* aabb_test;
    dGeomDtorFn* dtor;
} dGeomClass;

/** Register a class; returns its number, dFirstUserClass and up. Refused (-1) when the description is bad or
    dMaxUserClasses are taken. dCloseODE forgets the classes. */
ODE_API int dCreateGeomClass(const dGeomClass* classptr);

/** The data of a user-class geom: `bytes` bytes, zero at first. */
ODE_API void* dGeomGetClassData(dGeomID geom);

/** A geom of a user class, in no space. */
ODE_API dGeomID dCreateGeom(int classnum);

/** Collide classes i and j with this function from now on (and j with i by turning it round); 0
    lets the pair not collide at all. Process-wide, until dCloseODE. Needs an open library. */
ODE_API void dSetColliderOverride(int i, int j, dColliderFn* fn);

#ifdef __cplusplus
}
#endif

#endif
