// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangle meshes: the data object that any number of geoms share, and what a geom keeps of its own. The
// data copy the program's vertices and indices; they remember where these lie only for
// dGeomTriMeshDataUpdate. Data know their geoms: when they change, the geoms' boxes do, and when they go, the
// geoms have none left. While functions of the program run inside a collision, data and geoms are held:
// nothing is given up under the pair function that they return to.
#pragma once

#include <atomic>

#include "base/objects/pool.h"
#include "base/streams/structure_stream.h"
#include "bvh/mesh_tree.h"
#include "collide/geom.h"

namespace epode {

struct TrimeshGeom;

// The program's arrays, with strides in bytes.
struct MeshSource {
    const void* vertices = nullptr;
    int vertex_stride = 0;
    int vertex_count = 0;
    bool doubles = false;
    const void* indices = nullptr;
    int triangle_stride = 0;
    int triangle_count = 0;
};

struct TrimeshData : Numbered {
    TrimeshData();
    ~TrimeshData();
    TrimeshData(const TrimeshData&) = delete;
    TrimeshData& operator=(const TrimeshData&) = delete;

    bool in_use() const;  // a collision or a walk over a space relies on it
    void notify_geoms();  // that the mesh has changed

    TriangleMesh mesh;
    MeshTree tree;
    bool built = false;
    bool closed = false;  // see closed_mesh.h
    MeshSource source;
    const void* face_normals = nullptr;  // the program's
    void* given_flags = nullptr;         // the program's
    Array<unsigned char> use_flags;      // our own, on request
    TrimeshGeom* geoms = nullptr;
    SpinLock geoms_lock;  // geoms of several threads may share the data
    std::atomic<int> users{0};
};

// The mesh in files, where the program's arrays are left out. Null: loading has failed. (types/trimesh_data)
TrimeshData* structure(TrimeshData* data, StructureStream& stream);
void destroy(TrimeshData* data);

template <>
struct HandleOf<TrimeshData> {
    using Id = dTriMeshDataID;
    static constexpr Tag kTag = Tag::kTrimeshData;
};

// The shape of a mesh geom and the program's callbacks that decide about its contacts.
struct Trimesh {
    TrimeshData* data = nullptr;
    dTriCallback* wants = nullptr;
    dTriArrayCallback* array_callback = nullptr;
    dTriRayCallback* ray_hits = nullptr;
    dTriTriMergeCallback* merged = nullptr;
    int merging = dGeomColliderMergeContactsValue_None;  // of a ball's contacts, for a program
    bool solid = false;  // wanted; meshes that are not closed are surfaces all the same

    const TrimeshData* mesh() const { return data && data->built ? data : nullptr; }  // null: no triangles
    bool is_solid() const { return solid && mesh() && data->closed; }
    bool has_callbacks() const { return wants || array_callback || ray_hits || merged; }
};

struct TrimeshGeom : ShapeGeom<Trimesh> {
    explicit TrimeshGeom(const GeomType& geom_type) : ShapeGeom<Trimesh>(geom_type) {}
    ~TrimeshGeom() { use(nullptr); }
    void use(TrimeshData* fresh);  // or null

    TrimeshGeom* next_user = nullptr;  // of the same data
    TrimeshGeom* previous_user = nullptr;
    Real last_transform[16] = {};
    bool coherent[3] = {};  // kept for the program: for spheres, boxes and capsules
};

// Null if it is none.
TrimeshGeom* as_trimesh(Geom& geom);

// A geom and, of a mesh, its data, while functions of the program run.
class MeshHold {
  public:
    explicit MeshHold(Geom& geom);

  private:
    GeomHold geom_;
    CallGuard data_;
};

}  // namespace epode
