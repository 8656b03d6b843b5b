// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Types and constants of triangle meshes. Included by collision.h; do not include it alone.
#ifndef _ODE_COLLISION_TRIMESH_H_
#define _ODE_COLLISION_TRIMESH_H_

#ifdef __cplusplus
extern "C" {
#endif

struct dxTriMeshData;
typedef struct dxTriMeshData* dTriMeshDataID; /**< the triangles, shared by any number of geoms */

/** The corners of a triangle. */
typedef enum { dMTV__MIN, dMTV_FIRST = dMTV__MIN, dMTV_SECOND, dMTV_THIRD, dMTV__MAX } dMeshTriangleVertex;

/** Kinds of extra data that a mesh can carry. */
enum {
    dTRIMESHDATA__MIN,
    dTRIMESHDATA_FACE_NORMALS = dTRIMESHDATA__MIN, /**< a dVector3 per triangle */
    dTRIMESHDATA_USE_FLAGS,                        /**< a byte of dMESHDATAUSE_ bits per triangle */
    dTRIMESHDATA__MAX,
#ifndef TRIMESH_FACE_NORMALS
    TRIMESH_FACE_NORMALS = dTRIMESHDATA_FACE_NORMALS
#endif
};

/** Which edges and vertices a triangle is responsible for in collision. */
enum {
    dMESHDATAUSE_EDGE1 = 0x01,
    dMESHDATAUSE_EDGE2 = 0x02,
    dMESHDATAUSE_EDGE3 = 0x04,
    dMESHDATAUSE_VERTEX1 = 0x08,
    dMESHDATAUSE_VERTEX2 = 0x10,
    dMESHDATAUSE_VERTEX3 = 0x20
};

/** What preprocessing can build: bit numbers of a request. */
enum {
    dTRIDATAPREPROCESS_BUILD__MIN,
    dTRIDATAPREPROCESS_BUILD_CONCAVE_EDGES = dTRIDATAPREPROCESS_BUILD__MIN,
    dTRIDATAPREPROCESS_BUILD_FACE_ANGLES,
    dTRIDATAPREPROCESS_BUILD__MAX
};

/** How face angles are stored. */
enum {
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MIN,
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_BYTE_POSITIVE = dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MIN,
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_BYTE_ALL,
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_WORD_ALL,
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MAX,
    dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__DEFAULT = dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_BYTE_POSITIVE
};

/** May a triangle touch the other geom? Returns non-zero to let it. */
typedef int dTriCallback(dGeomID TriMesh, dGeomID RefObject, int TriangleIndex);

/** Told all triangles that touch the other geom. */
typedef void dTriArrayCallback(dGeomID TriMesh, dGeomID RefObject, const int* TriIndices, int TriCount);

/** Does a ray's hit at barycentric coordinates (u, v) of a triangle count? Returns non-zero if so. */
typedef int dTriRayCallback(dGeomID TriMesh, dGeomID Ray, int TriangleIndex, dReal u, dReal v);

/** Which triangle number a contact gets that is merged from those of two triangles. */
typedef int dTriTriMergeCallback(dGeomID TriMesh, int FirstTriangleIndex, int SecondTriangleIndex);

#ifdef __cplusplus
}
#endif

#endif
