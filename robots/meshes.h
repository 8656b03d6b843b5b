// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles from STL (binary and text), OBJ (corners and faces) and DAE (geometry of the scene, in metres, z up).
#pragma once

#include "robots/model.h"

namespace epode::robots {

// False and a problem: another kind of file, a broken one, no triangles, numbers that are not finite.
bool read_mesh(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem);
// Factors of an odd number of mirrors turn the triangles round.
void scale_mesh(Mesh& mesh, Vec factors);

// What the triangles enclose, at density 1: about its centre. Where the mesh counts folds, as MuJoCo does unless it is
// told otherwise, each pyramid from the middle of the surface counts as positive: for convex meshes it is the same. False where that is nothing.
struct Solid {
    double volume = 0;
    Vec centre;
    Matrix inertia{};
};
bool solid_of(const Mesh& mesh, Solid& solid);

}  // namespace epode::robots
