// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where two wheels touch, or a chain between them runs straight: the line l along which their rims push or
// pull, and a point of it on each wheel. Wheel i has centre a_i, axis n_i (unit) and, in its plane, the spoke
// c_i - a_i.
//
//   parallel axes      c1 = c2 on the segment a1 a2, divided as the ratio r1/r2 says;  l = d x n,
//                      d = a2 - a1 across n,  n the mean axis
//   intersecting axes  l = n1 x n2, the line common to both wheels' planes; c_i the nearest point of it to a_i
//   chain drive        c_i = a_i + r_i u,  u.d = (r1 - r2)/|d|: the outer common tangent on the side n x d,
//                      or on the other side when mirrored;  l = u x n
//
// The forces on the wheels act on one line, so that neither momentum nor moment is made: with parallel axes
// that are not quite parallel l belongs to their mean, and the chain runs half way between wheels at
// different heights.
#pragma once

#include "math/vec.h"

namespace epode {

struct Wheel {
    Vec3 centre, axis;
};

struct GearMesh {
    Vec3 line;        // unit
    Vec3 contact[2];  // of each wheel
};

// False, and `mesh` untouched, where wheels have no such line: centres on one axis, or axes parallel that are
// to intersect.
bool mesh_parallel(const Wheel (&wheel)[2], Real ratio, GearMesh& mesh);
bool mesh_intersecting(const Wheel (&wheel)[2], GearMesh& mesh);
bool mesh_chain(const Wheel (&wheel)[2], const Real (&radius)[2], bool mirrored, GearMesh& mesh);

}  // namespace epode
