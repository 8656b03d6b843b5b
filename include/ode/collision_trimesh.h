/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Triangle meshes. Included by collision.h; do not include it alone. */
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
    dTRIMESHDATA_FACE_NORMALS = dTRIMESHDATA__MIN, /**< three dReal per triangle */
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

/** @chapter trimeshes Triangle meshes

    Surfaces of triangles, open or closed. The front of a triangle v0, v1, v2 is where it runs
    counter-clockwise. A mesh is met at its surface: what lies wholly inside a closed one touches nothing. The
    triangles are data that any number of geoms share.

    Vertices and indices are copied when data are built and when dGeomTriMeshDataUpdate is called, and read at
    no other time: the program may change or free its arrays in between, but must keep them, or others at the
    same place, for an update. Normals and use flags are not copied: the program keeps them alive. Edges are
    recognised by equal indices or by exactly equal positions, so meshes that repeat their vertices for every
    triangle are as good as others. A triangle without area keeps its number and touches nothing.

    Arguments:
    - g: the data in functions named dGeomTriMeshData..., else the geom.
    - Data: the triangles of a geom, or 0 for none.
    - Vertices, VertexCount: VertexCount >= 1 times x, y, z, m, in the frame of the geom.
    - VertexStride: bytes from a vertex to the next, at least what three numbers take.
    - Indices, IndexCount: three numbers of vertices, from 0, for each triangle; a multiple of 3 in all.
    - TriStride: bytes from a triangle to the next, at least what three indices take.
    - Index: the number of a triangle, from 0.
    - Callback, ArrayCallback, RayCallback: functions that have a say in the contacts of a mesh, or 0. While
    they run, the geoms and the data of the pair cannot be destroyed or given other triangles.

    Refused: data or a geom that is 0, destroyed or no mesh; null pointers; [dGeomTriMeshDataBuild] counts
    and strides that are too small; [dGeomTriMeshDataBuild] an index beyond the vertices;
    [dGeomTriMeshDataBuild] a coordinate that is no finite number. Nothing changes then, and the answer is
    0. */

/** May a triangle touch the other geom? Returns non-zero to let it. */
typedef int dTriCallback(dGeomID TriMesh, dGeomID RefObject, int TriangleIndex);

/** Told all triangles that touch the other geom. */
typedef void dTriArrayCallback(dGeomID TriMesh, dGeomID RefObject, const int* TriIndices, int TriCount);

/** Does a ray's hit at barycentric coordinates (u, v) of a triangle count? Returns non-zero if so. */
typedef int dTriRayCallback(dGeomID TriMesh, dGeomID Ray, int TriangleIndex, dReal u, dReal v);

/** Which triangle number a contact gets that is merged from those of two triangles. */
typedef int dTriTriMergeCallback(dGeomID TriMesh, int FirstTriangleIndex, int SecondTriangleIndex);

/** - dGeomTriMeshDataCreate: New data for the triangles of one or more geoms, empty at first.
    - dGeomTriMeshDataDestroy: Destroy the data g; geoms that have them touch nothing afterwards. Refused
      during a collision that may need them. [0.16] */
ODE_API dTriMeshDataID dGeomTriMeshDataCreate(void);
ODE_API void dGeomTriMeshDataDestroy(dTriMeshDataID g);

/** Data that have been built already get new triangles, and their geoms with them. Refused during a
    collision that needs the data.
    - dGeomTriMeshDataBuildSingle: Set the triangles of the data g from vertices of type float. Edges that
      the rounding to floats may have bent count as flat.
    - dGeomTriMeshDataBuildSingle1: Set the triangles of the data g from vertices of type float, and their
      normals. Edges that the rounding to floats may have bent count as flat. Normals: three dReal for each
      triangle, or 0, as for dTRIMESHDATA_FACE_NORMALS.
    - dGeomTriMeshDataBuildDouble: Set the triangles of the data g from vertices of type double.
    - dGeomTriMeshDataBuildDouble1: Set the triangles of the data g from vertices of type double, and their
      normals. Normals: three dReal for each triangle, or 0, as for dTRIMESHDATA_FACE_NORMALS.
    - dGeomTriMeshDataBuildSimple: Set the triangles of the data g from vertices of type dVector3 and
      indices, both without gaps.
    - dGeomTriMeshDataBuildSimple1: Set the triangles of the data g from vertices of type dVector3 and
      indices, both without gaps, and their normals. Normals: three dReal for each triangle, behind a pointer
      of another type, or 0, as for dTRIMESHDATA_FACE_NORMALS. [0.16] */
ODE_API void dGeomTriMeshDataBuildSingle(dTriMeshDataID g, const void* Vertices, int VertexStride,
                                         int VertexCount, const void* Indices, int IndexCount, int TriStride);
ODE_API void dGeomTriMeshDataBuildSingle1(dTriMeshDataID g, const void* Vertices, int VertexStride,
                                          int VertexCount, const void* Indices, int IndexCount, int TriStride,
                                          const void* Normals);
ODE_API void dGeomTriMeshDataBuildDouble(dTriMeshDataID g, const void* Vertices, int VertexStride,
                                         int VertexCount, const void* Indices, int IndexCount, int TriStride);
ODE_API void dGeomTriMeshDataBuildDouble1(dTriMeshDataID g, const void* Vertices, int VertexStride,
                                          int VertexCount, const void* Indices, int IndexCount, int TriStride,
                                          const void* Normals);
ODE_API void dGeomTriMeshDataBuildSimple(dTriMeshDataID g, const dReal* Vertices, int VertexCount,
                                         const dTriIndex* Indices, int IndexCount);
ODE_API void dGeomTriMeshDataBuildSimple1(dTriMeshDataID g, const dReal* Vertices, int VertexCount,
                                          const dTriIndex* Indices, int IndexCount, const int* Normals);

/** Read the arrays that the data were built from again, after the program has moved vertices or, which costs
    as much as building, changed indices. Edges stay those that they were. The bounding boxes of the geoms
    follow. Refused, and nothing changes, for data that are not built, numbers that building refuses, and
    while a collision goes on that needs the data. [0.16] */
ODE_API void dGeomTriMeshDataUpdate(dTriMeshDataID g);

/** CONCAVE_EDGES makes the use flags: dMESHDATAUSE_ bits for each triangle; every edge that is not concave
    and every vertex without concave edges is given to one triangle, the one with the lowest index. Returns
    1, or 0 if memory is exhausted or the call is refused. Calling it again computes again. Face normals that
    are not unit vectors are refused.
    - dGeomTriMeshDataPreprocess: Compute CONCAVE_EDGES for the data g: dGeomTriMeshDataPreprocess2 with that
      bit alone.
    - dGeomTriMeshDataPreprocess2: Compute for the data g what buildRequestFlags asks for, bits 1 <<
      dTRIDATAPREPROCESS_BUILD_... FACE_ANGLES makes nothing, as all that contacts need is always there; its
      extra data, requestExtraData[dTRIDATAPREPROCESS_BUILD_FACE_ANGLES], is checked. requestExtraData may be
      0. [0.16] */
ODE_API int dGeomTriMeshDataPreprocess(dTriMeshDataID g);
ODE_API int dGeomTriMeshDataPreprocess2(dTriMeshDataID g, unsigned int buildRequestFlags,
                                        const dintptr* requestExtraData);

/** Contacts do not use these data: they are there for programs that store them.
    - dGeomTriMeshDataSet: Give the data g an array of the program's own, in_data, for data_id
      (dTRIMESHDATA_...); it is not copied. Use flags that are given hide those that have been computed until
      they are set to 0.
    - dGeomTriMeshDataGet2: The array for data_id (dTRIMESHDATA_...) that the program has set or the library
      has computed, else 0. The number of its bytes is written to *pout_size unless pout_size is 0. [0.16] */
ODE_API void dGeomTriMeshDataSet(dTriMeshDataID g, int data_id, void* in_data);
ODE_API void* dGeomTriMeshDataGet2(dTriMeshDataID g, int data_id, dsizeint* pout_size);

/** - dGeomTriMeshDataGetBuffer: Old form that reads the use flags of the data g: a pointer to them is
      written to *buf, their number to *bufLen; either pointer may be 0.
    - dGeomTriMeshDataSetBuffer: Old form that sets the use flags of the data g: buf are the flags, one byte
      for each triangle. [0.16] */
ODE_API_DEPRECATED ODE_API void dGeomTriMeshDataGetBuffer(dTriMeshDataID g, unsigned char** buf, int* bufLen);
ODE_API_DEPRECATED ODE_API void dGeomTriMeshDataSetBuffer(dTriMeshDataID g, unsigned char* buf);

/** - dCreateTriMesh: A new mesh in the space, or (0) in none, of the triangles Data, with three functions of
      the program, each of which may be 0. Its bounding box is that of the data, turned.
    - dGeomTriMeshSetData: Give the mesh g other triangles, Data. Refused while the geom is being collided.
    - dGeomTriMeshGetData: The data of the mesh g, or 0.
    - dGeomTriMeshGetTriMeshDataID: The data of the mesh g, or 0; the same answer as dGeomTriMeshGetData.
      [0.16] */
ODE_API dGeomID dCreateTriMesh(dSpaceID space, dTriMeshDataID Data, dTriCallback* Callback,
                               dTriArrayCallback* ArrayCallback, dTriRayCallback* RayCallback);
ODE_API void dGeomTriMeshSetData(dGeomID g, dTriMeshDataID Data);
ODE_API dTriMeshDataID dGeomTriMeshGetData(dGeomID g);
ODE_API dTriMeshDataID dGeomTriMeshGetTriMeshDataID(dGeomID g);

/** - dGeomTriMeshSetCallback: Set the function that accepts or refuses contacts of the mesh g with a
      triangle; 0: none. It is called for triangles near the other geom, which need not touch it, and for
      hits of rays. A refused triangle is a hole: solids rest on the edges towards it.
    - dGeomTriMeshGetCallback: The function that dGeomTriMeshSetCallback has set, or 0.
    - dGeomTriMeshSetArrayCallback: Set the function that is given all triangles of the mesh g near the other
      geom at once; 0: none. They need not touch it.
    - dGeomTriMeshGetArrayCallback: The function that dGeomTriMeshSetArrayCallback has set, or 0.
    - dGeomTriMeshSetRayCallback: Set the function that accepts or refuses hits of rays on the mesh g, from
      the nearest on, until enough are accepted; 0: none. The one of dGeomTriMeshSetCallback is asked after
      it, and both must accept.
    - dGeomTriMeshGetRayCallback: The function that dGeomTriMeshSetRayCallback has set, or 0.
    - dGeomTriMeshSetTriMergeCallback: Set the function that is called when contacts of two triangles of the
      mesh g, at the same place and with the same normal, become one, and that gives the contact its index;
      0: none,
      so that the contact has the index of the deeper one.
    - dGeomTriMeshGetTriMergeCallback: The function that dGeomTriMeshSetTriMergeCallback has set, or 0.
      [0.16] */
ODE_API void dGeomTriMeshSetCallback(dGeomID g, dTriCallback* Callback);
ODE_API dTriCallback* dGeomTriMeshGetCallback(dGeomID g);
ODE_API void dGeomTriMeshSetArrayCallback(dGeomID g, dTriArrayCallback* ArrayCallback);
ODE_API dTriArrayCallback* dGeomTriMeshGetArrayCallback(dGeomID g);
ODE_API void dGeomTriMeshSetRayCallback(dGeomID g, dTriRayCallback* Callback);
ODE_API dTriRayCallback* dGeomTriMeshGetRayCallback(dGeomID g);
ODE_API void dGeomTriMeshSetTriMergeCallback(dGeomID g, dTriTriMergeCallback* Callback);
ODE_API dTriTriMergeCallback* dGeomTriMeshGetTriMergeCallback(dGeomID g);

/** How many triangles there are, those without area included; 0 without data. [0.16] */
ODE_API int dGeomTriMeshGetTriangleCount(dGeomID g);

/** - dGeomTriMeshGetTriangle: Write the corners of triangle Index of the mesh g in the world, m, to *v0, *v1
      and *v2; some of the pointers may be 0, but not all.
    - dGeomTriMeshGetPoint: Write the point (1 - u - v) a + u b + v c of triangle Index of the mesh g,
      with its corners a, b, c in the world, m, to Out. [0.16] */
ODE_API void dGeomTriMeshGetTriangle(dGeomID g, int Index, dVector3* v0, dVector3* v1, dVector3* v2);
ODE_API void dGeomTriMeshGetPoint(dGeomID g, int Index, dReal u, dReal v, dVector3 Out);

/** Contacts do not need it.
    - dGeomTriMeshSetLastTransform: Store 16 reals, last_trans, for the program: a place for the pose of the
      step before.
    - dGeomTriMeshGetLastTransform: A pointer to the 16 reals that dGeomTriMeshSetLastTransform has stored,
      zeros at first; valid as long as the geom. [0.16] */
ODE_API void dGeomTriMeshSetLastTransform(dGeomID g, const dMatrix4 last_trans);
ODE_API const dReal* dGeomTriMeshGetLastTransform(dGeomID g);

/** The setting is stored for the program; the library keeps no such memory.
    - dGeomTriMeshEnableTC: Say whether (enable not 0) what is found out about geoms of class geomClass may
      be remembered for their next collision; default 0. It holds for dSphereClass, dBoxClass and
      dCapsuleClass; others stay 0.
    - dGeomTriMeshIsTCEnabled: Whether dGeomTriMeshEnableTC has been switched on for class geomClass: 1 or 0.
    - dGeomTriMeshClearTCCache: Does nothing: there is nothing to be cleared. [0.16] */
ODE_API void dGeomTriMeshEnableTC(dGeomID g, int geomClass, int enable);
ODE_API int dGeomTriMeshIsTCEnabled(dGeomID g, int geomClass);
ODE_API void dGeomTriMeshClearTCCache(dGeomID g);

#ifdef __cplusplus
}
#endif

#endif
