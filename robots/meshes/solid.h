// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the triangles of a mesh enclose, at density 1 and about its centre.
#pragma once

#include "robots/model.h"

namespace epode::robots {

struct Solid {
    double volume = 0;
    Vec centre;
    Matrix inertia{};
};

// Where the mesh counts folds, as MuJoCo does unless a file says otherwise, each pyramid from the middle of the surface
// counts as positive: of convex meshes that is the same. False where the volume is nothing.
bool solid_of(const Mesh& mesh, Solid& solid);

}  // namespace epode::robots
