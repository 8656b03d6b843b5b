// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Grounds that are all the plane z = 0 to what moves on them: the plane itself, a box, one mesh of many
// triangles, one that falls away beyond y = 0 (bodies whose boxes reach there are on no plane), two meshes
// laid edge to edge, a height field.
#pragma once

#include <vector>

#include "rig.h"

namespace epode::physics {

// A mesh geom that owns its data and arrays.
class MeshGeom {
  public:
    MeshGeom(dSpaceID space, std::vector<dReal> vertices, std::vector<dTriIndex> triangles)
        : vertices_(std::move(vertices)), triangles_(std::move(triangles)), data_(dGeomTriMeshDataCreate())
    {
        dGeomTriMeshDataBuildSimple(data_, vertices_.data(), int(vertices_.size() / 4), triangles_.data(),
                                    int(triangles_.size()));
        geom = dCreateTriMesh(space, data_, nullptr, nullptr, nullptr);
    }
    MeshGeom(const MeshGeom&) = delete;
    MeshGeom& operator=(const MeshGeom&) = delete;
    ~MeshGeom()
    {
        dGeomDestroy(geom);
        dGeomTriMeshDataDestroy(data_);
    }
    dGeomID geom;

  private:
    std::vector<dReal> vertices_;
    std::vector<dTriIndex> triangles_;
    dTriMeshDataID data_;
};

enum class Floor { kPlane, kBox, kMesh, kRidge, kTwoMeshes, kField };
inline const char* name_of(Floor f)
{
    switch (f) {
        case Floor::kPlane:
            return "plane";
        case Floor::kBox:
            return "box";
        case Floor::kMesh:
            return "mesh";
        case Floor::kRidge:
            return "next to a ridge";
        case Floor::kTwoMeshes:
            return "two meshes";
        default:
            return "field";
    }
}

// cells x cells squares of `cell` metres about the origin; two meshes meet at x = 0.
class FlatGround {
  public:
    FlatGround(Sim& sim, Floor floor, int cells, double cell);
    ~FlatGround();
    FlatGround(const FlatGround&) = delete;
    FlatGround& operator=(const FlatGround&) = delete;

  private:
    std::vector<MeshGeom*> meshes_;
    dGeomID other_ = nullptr;
    dHeightfieldDataID field_ = nullptr;
    std::vector<double> heights_;
};

// A box of 12 triangles about the origin.
inline MeshGeom* box_mesh(dSpaceID space, V3 size)
{
    std::vector<dReal> v;
    for (int i = 0; i < 8; ++i) {
        v.push_back(real((i & 1 ? 0.5 : -0.5) * size.x)), v.push_back(real((i & 2 ? 0.5 : -0.5) * size.y));
        v.push_back(real((i & 4 ? 0.5 : -0.5) * size.z)), v.push_back(0);
    }
    return new MeshGeom(space, std::move(v), {4, 5, 7, 4, 7, 6, 0, 2, 3, 0, 3, 1, 1, 3, 7, 1, 7, 5,
                                              0, 4, 6, 0, 6, 2, 2, 6, 7, 2, 7, 3, 0, 1, 5, 0, 5, 4});
}

}  // namespace epode::physics
