// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The grounds: see ground.h.
#include "bench/collision/ground.h"

#include <cmath>

namespace epode::bench {

double ground_height(double x, double y)
{
    return 1.5 * std::sin(0.11 * x) * std::cos(0.13 * y) + 0.3 * std::sin(0.7 * x + 0.2) * std::sin(0.6 * y) +
           0.04 * std::sin(3.1 * x) * std::cos(2.7 * y);
}

MeshGround::MeshGround(int n)
{
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = kGroundCell * (i - 0.5 * n), y = kGroundCell * (j - 0.5 * n);
            for (const double v : {x, y, ground_height(x, y), 0.0}) vertices_.push_back(dReal(v));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const dTriIndex a = dTriIndex(i + j * (n + 1)), b = a + 1, c = a + dTriIndex(n) + 1, d = c + 1;
            for (const dTriIndex corner : {a, b, d, a, d, c}) corners_.push_back(corner);
        }
    dGeomTriMeshDataBuildSimple(data_, vertices_.data(), int(vertices_.size() / 4), corners_.data(),
                                int(corners_.size()));
    // Debian's library ends the program on a polyhedron against a mesh without these.
    dGeomTriMeshDataPreprocess2(data_, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
}

MeshGround::~MeshGround()
{
    dGeomDestroy(geom_);
    dGeomTriMeshDataDestroy(data_);
}

// Its own y up is the world's z, its z against the world's y.
FieldGround::FieldGround(int n)
{
    std::vector<double> heights;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            heights.push_back(ground_height(kGroundCell * (i - 0.5 * n), -kGroundCell * (j - 0.5 * n)));
    dGeomHeightfieldDataBuildDouble(data_, heights.data(), 1, dReal(kGroundCell * n), dReal(kGroundCell * n),
                                    n + 1, n + 1, 1, 0, 1, 0);
    geom_ = dCreateHeightfield(nullptr, data_, 1);
    const dMatrix3 up = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
    dGeomSetRotation(geom_, up);
}

FieldGround::~FieldGround()
{
    dGeomDestroy(geom_);
    dGeomHeightfieldDataDestroy(data_);
}

}  // namespace epode::bench
