// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Masses of shapes, sums of masses, and what no body can have.
#pragma once

#include "robots/model.h"

namespace epode::robots {

// Mass, centre and inertia about the centre, in the axes of one frame.
struct Inertia {
    double mass = 0;
    Vec centre;
    Matrix tensor{};
    Quat axes{};  // along which a single part has its moments
};

// Of the whole shape at density 1, in the link's frame. Zero for planes and height fields, and for triangles that enclose nothing.
Inertia inertia_of(const Shape& shape, const std::vector<Mesh>& meshes);
// Of its surface at mass 1 per area. An ellipsoid's area is Thomsen's approximation, within 1.1 %, and its thickness is the same
// along each axis, as MuJoCo has it.
Inertia shell_of(const Shape& shape, const std::vector<Mesh>& meshes);
Inertia with_mass(Inertia inertia, double mass);
Inertia sum_of(const Inertia& a, const Inertia& b);
Inertia moved(const Inertia& inertia, const Pose& pose);

// "" for what a body can have, else what is wrong: moments that are not positive, or one larger than the sum of the
// others (by more than 1e-9 of the trace).
std::string fault_of(const Matrix& inertia);
// The nearest that a body can have: axes kept, moments raised to it.
Matrix mended(const Matrix& inertia, double mass);

}  // namespace epode::robots
