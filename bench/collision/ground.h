// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The terrain of scene S7 as a geom: hills of several wavelengths over n x n cells of half a metre, a mesh of
// two triangles a cell or a height field of the same heights (other diagonals), z up.
#pragma once

#include <ode/ode.h>

#include <vector>

namespace epode::bench {

inline constexpr double kGroundCell = 0.5;

double ground_height(double x, double y);

class MeshGround {
  public:
    explicit MeshGround(int n);
    MeshGround(const MeshGround&) = delete;
    MeshGround& operator=(const MeshGround&) = delete;
    ~MeshGround();
    dGeomID geom() const { return geom_; }

  private:
    std::vector<dReal> vertices_;
    std::vector<dTriIndex> corners_;
    dTriMeshDataID data_ = dGeomTriMeshDataCreate();
    dGeomID geom_ = nullptr;
};

class FieldGround {
  public:
    explicit FieldGround(int n);
    FieldGround(const FieldGround&) = delete;
    FieldGround& operator=(const FieldGround&) = delete;
    ~FieldGround();
    dGeomID geom() const { return geom_; }

  private:
    dHeightfieldDataID data_ = dGeomHeightfieldDataCreate();
    dGeomID geom_ = nullptr;
};

}  // namespace epode::bench
