// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms.
#ifndef _ODE_COLLISION_H_
#define _ODE_COLLISION_H_

#include <ode/common.h>
#include <ode/collision_space.h>
#include <ode/contact.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CONTACTS_UNIMPORTANT 0x80000000
enum { dGeomCommonControlClass = 0, dGeomColliderControlClass = 1 };
enum {
  dGeomCommonAnyControlCode = 0,
  dGeomColliderSetMergeSphereContactsControlCode = 1,
  dGeomColliderGetMergeSphereContactsControlCode = 2
};
enum {
  dGeomColliderMergeContactsValue__Default = 0,
  dGeomColliderMergeContactsValue_None = 1,
  dGeomColliderMergeContactsValue_Normals = 2,
  dGeomColliderMergeContactsValue_Full = 3
};
enum { dMaxUserClasses = 4 };
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
#define dCreateCCylinder dCreateCapsule
#define dGeomCCylinderSetParams dGeomCapsuleSetParams
#define dGeomCCylinderGetParams dGeomCapsuleGetParams
#define dGeomCCylinderPointDepth dGeomCapsulePointDepth
#define dCCylinderClass dCapsuleClass
struct dxHeightfieldData;
typedef struct dxHeightfieldData *dHeightfieldDataID;
typedef dReal dHeightfieldGetHeight(void *p_user_data, int x, int z);
typedef void dGetAABBFn(dGeomID geom, dReal aabb[6]);
typedef int dColliderFn(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip);
typedef dColliderFn *dGetColliderFnFn(int num);
typedef void dGeomDtorFn(dGeomID o);
typedef int dAABBTestFn(dGeomID o1, dGeomID o2, dReal aabb[6]);
typedef struct dGeomClass {
  int bytes;
  dGetColliderFnFn *collider;
  dGetAABBFn *aabb;
  dAABBTestFn *aabb_test;
  dGeomDtorFn *dtor;
} dGeomClass;

ODE_API int dBoxBox(const dVector3 p1, const dMatrix3 R1, const dVector3 side1, const dVector3 p2, const dMatrix3 R2, const dVector3 side2, dVector3 normal, dReal *depth, int *return_code, int flags, dContactGeom *contact, int skip);
ODE_API int dBoxTouchesBox(const dVector3 _p1, const dMatrix3 R1, const dVector3 side1, const dVector3 _p2, const dMatrix3 R2, const dVector3 side2);
ODE_API void dClosestLineSegmentPoints(const dVector3 a1, const dVector3 a2, const dVector3 b1, const dVector3 b2, dVector3 cp1, dVector3 cp2);
ODE_API int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom *contact, int skip);
ODE_API dGeomID dCreateBox(dSpaceID space, dReal lx, dReal ly, dReal lz);
ODE_API dGeomID dCreateCapsule(dSpaceID space, dReal radius, dReal length);
ODE_API dGeomID dCreateCylinder(dSpaceID space, dReal radius, dReal length);
ODE_API dGeomID dCreateGeom(int classnum);
ODE_API int dCreateGeomClass(const dGeomClass *classptr);
ODE_API_DEPRECATED ODE_API dGeomID dCreateGeomTransform(dSpaceID space);
ODE_API dGeomID dCreatePlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d);
ODE_API dGeomID dCreateRay(dSpaceID space, dReal length);
ODE_API dGeomID dCreateSphere(dSpaceID space, dReal radius);
ODE_API void dGeomBoxGetLengths(dGeomID box, dVector3 result);
ODE_API dReal dGeomBoxPointDepth(dGeomID box, dReal x, dReal y, dReal z);
ODE_API void dGeomBoxSetLengths(dGeomID box, dReal lx, dReal ly, dReal lz);
ODE_API void dGeomCapsuleGetParams(dGeomID ccylinder, dReal *radius, dReal *length);
ODE_API dReal dGeomCapsulePointDepth(dGeomID ccylinder, dReal x, dReal y, dReal z);
ODE_API void dGeomCapsuleSetParams(dGeomID ccylinder, dReal radius, dReal length);
ODE_API void dGeomClearOffset(dGeomID geom);
ODE_API void dGeomCopyOffsetPosition(dGeomID geom, dVector3 pos);
ODE_API void dGeomCopyOffsetRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomCopyPosition(dGeomID geom, dVector3 pos);
ODE_API void dGeomCopyRotation(dGeomID geom, dMatrix3 R);
ODE_API void dGeomCylinderGetParams(dGeomID cylinder, dReal *radius, dReal *length);
ODE_API void dGeomCylinderSetParams(dGeomID cylinder, dReal radius, dReal length);
ODE_API void dGeomDestroy(dGeomID geom);
ODE_API void dGeomDisable(dGeomID geom);
ODE_API void dGeomEnable(dGeomID geom);
ODE_API void dGeomGetAABB(dGeomID geom, dReal aabb[6]);
ODE_API dBodyID dGeomGetBody(dGeomID geom);
ODE_API unsigned long dGeomGetCategoryBits(dGeomID);
ODE_API int dGeomGetClass(dGeomID geom);
ODE_API void * dGeomGetClassData(dGeomID);
ODE_API unsigned long dGeomGetCollideBits(dGeomID);
ODE_API void *dGeomGetData(dGeomID geom);
ODE_API const dReal * dGeomGetOffsetPosition(dGeomID geom);
ODE_API void dGeomGetOffsetQuaternion(dGeomID geom, dQuaternion result);
ODE_API const dReal * dGeomGetOffsetRotation(dGeomID geom);
ODE_API void dGeomGetPosRelPoint( dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API const dReal * dGeomGetPosition(dGeomID geom);
ODE_API void dGeomGetQuaternion(dGeomID geom, dQuaternion result);
ODE_API void dGeomGetRelPointPos( dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API const dReal * dGeomGetRotation(dGeomID geom);
ODE_API dSpaceID dGeomGetSpace(dGeomID);
ODE_API int dGeomIsEnabled(dGeomID geom);
ODE_API int dGeomIsOffset(dGeomID geom);
ODE_API int dGeomIsSpace(dGeomID geom);
ODE_API int dGeomLowLevelControl(dGeomID geom, int controlClass, int controlCode, void *dataValue, int *dataSize);
ODE_API void dGeomPlaneGetParams(dGeomID plane, dVector4 result);
ODE_API dReal dGeomPlanePointDepth(dGeomID plane, dReal x, dReal y, dReal z);
ODE_API void dGeomPlaneSetParams(dGeomID plane, dReal a, dReal b, dReal c, dReal d);
ODE_API void dGeomRayGet(dGeomID ray, dVector3 start, dVector3 dir);
ODE_API int dGeomRayGetBackfaceCull(dGeomID g);
ODE_API int dGeomRayGetClosestHit(dGeomID g);
ODE_API int dGeomRayGetFirstContact(dGeomID g);
ODE_API dReal dGeomRayGetLength(dGeomID ray);
ODE_API_DEPRECATED ODE_API void dGeomRayGetParams(dGeomID g, int *FirstContact, int *BackfaceCull);
ODE_API void dGeomRaySet(dGeomID ray, dReal px, dReal py, dReal pz, dReal dx, dReal dy, dReal dz);
ODE_API void dGeomRaySetBackfaceCull(dGeomID g, int backfaceCull);
ODE_API void dGeomRaySetClosestHit(dGeomID g, int closestHit);
ODE_API void dGeomRaySetFirstContact(dGeomID g, int firstContact);
ODE_API void dGeomRaySetLength(dGeomID ray, dReal length);
ODE_API_DEPRECATED ODE_API void dGeomRaySetParams(dGeomID g, int FirstContact, int BackfaceCull);
ODE_API void dGeomSetBody(dGeomID geom, dBodyID body);
ODE_API void dGeomSetCategoryBits(dGeomID geom, unsigned long bits);
ODE_API void dGeomSetCollideBits(dGeomID geom, unsigned long bits);
ODE_API void dGeomSetData(dGeomID geom, void* data);
ODE_API void dGeomSetOffsetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetQuaternion(dGeomID geom, const dQuaternion Q);
ODE_API void dGeomSetOffsetRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetOffsetWorldPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetOffsetWorldQuaternion(dGeomID geom, const dQuaternion);
ODE_API void dGeomSetOffsetWorldRotation(dGeomID geom, const dMatrix3 R);
ODE_API void dGeomSetPosition(dGeomID geom, dReal x, dReal y, dReal z);
ODE_API void dGeomSetQuaternion(dGeomID geom, const dQuaternion Q);
ODE_API void dGeomSetRotation(dGeomID geom, const dMatrix3 R);
ODE_API dReal dGeomSphereGetRadius(dGeomID sphere);
ODE_API dReal dGeomSpherePointDepth(dGeomID sphere, dReal x, dReal y, dReal z);
ODE_API void dGeomSphereSetRadius(dGeomID sphere, dReal radius);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetCleanup(dGeomID g);
ODE_API_DEPRECATED ODE_API dGeomID dGeomTransformGetGeom(dGeomID g);
ODE_API_DEPRECATED ODE_API int dGeomTransformGetInfo(dGeomID g);
ODE_API_DEPRECATED ODE_API void dGeomTransformSetCleanup(dGeomID g, int mode);
ODE_API_DEPRECATED ODE_API void dGeomTransformSetGeom(dGeomID g, dGeomID obj);
ODE_API_DEPRECATED ODE_API void dGeomTransformSetInfo(dGeomID g, int mode);
ODE_API void dGeomVectorFromWorld( dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API void dGeomVectorToWorld( dGeomID geom, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API void dInfiniteAABB(dGeomID geom, dReal aabb[6]);
ODE_API void dSetColliderOverride(int i, int j, dColliderFn *fn);
ODE_API void dSpaceCollide(dSpaceID space, void *data, dNearCallback *callback);
ODE_API void dSpaceCollide2(dGeomID space1, dGeomID space2, void *data, dNearCallback *callback);

#ifdef __cplusplus
}
#endif

#endif
