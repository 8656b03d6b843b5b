// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_floors.h.
#include "mesh_floors.h"

namespace epode::physics {

namespace {

// nx x ny cells from the corner (x, y).
MeshGeom* sheet(dSpaceID space, double x, double y, int nx, int ny, double cell, double fall = 0)
{
    std::vector<dReal> v;
    std::vector<dTriIndex> t;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) {
            v.push_back(real(x + i * cell)), v.push_back(real(y + j * cell));
            v.push_back(real(y + j * cell > 0.5 * cell ? -fall : 0)), v.push_back(0);
        }
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const dTriIndex a = dTriIndex(i + j * (nx + 1)), b = a + 1, c = a + dTriIndex(nx) + 1, d = c + 1;
            for (const dTriIndex corner : {a, b, d, a, d, c}) t.push_back(corner);
        }
    return new MeshGeom(space, std::move(v), std::move(t));
}

}  // namespace

FlatGround::FlatGround(Sim& sim, Floor floor, int cells, double cell)
{
    const double half = 0.5 * cells * cell;
    switch (floor) {
        case Floor::kPlane:
            other_ = dCreatePlane(sim.space, 0, 0, 1, 0);
            break;
        case Floor::kBox:
            other_ = dCreateBox(sim.space, real(2 * half), real(2 * half), 1);
            dGeomSetPosition(other_, 0, 0, real(-0.5));
            break;
        case Floor::kMesh:
            meshes_.push_back(sheet(sim.space, -half, -half, cells, cells, cell));
            break;
        case Floor::kRidge:
            meshes_.push_back(sheet(sim.space, -half, -half, cells, cells, cell, 0.5 * cell));
            break;
        case Floor::kTwoMeshes:
            meshes_.push_back(sheet(sim.space, -half, -half, cells / 2, cells, cell));
            meshes_.push_back(sheet(sim.space, 0, -half, cells / 2, cells, cell));
            break;
        case Floor::kField: {
            heights_.assign(std::size_t(cells + 1) * std::size_t(cells + 1), 0);
            field_ = dGeomHeightfieldDataCreate();
            dGeomHeightfieldDataBuildDouble(field_, heights_.data(), 0, real(2 * half), real(2 * half),
                                            cells + 1, cells + 1, 1, 0, 1, 0);
            other_ = dCreateHeightfield(sim.space, field_, 1);
            const dMatrix3 up = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
            dGeomSetRotation(other_, up);
            break;
        }
    }
}

FlatGround::~FlatGround()
{
    for (MeshGeom* m : meshes_) delete m;
    if (other_) dGeomDestroy(other_);
    if (field_) dGeomHeightfieldDataDestroy(field_);
}

}  // namespace epode::physics
