// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rotations made from what clients have: axis and angle, Euler angles, axes, or a matrix that is only
// nearly a rotation. Angles in radian, right-hand rule, matrices map body to world (math/pose.h).
#pragma once

#include "math/pose.h"

namespace epode {

// The rotation by `angle` about `axis` of any length; a zero axis gives the identity.
Quat rotation_about(Vec3 axis, Real angle);

// Rx(-phi) Ry(-theta) Rz(-psi): ODE's dRFromEulerAngles, the transpose of the textbook roll-pitch-yaw.
Mat3 rotation_from_euler(Real phi, Real theta, Real psi);

// Columns: a normalised; b made perpendicular to it and normalised; their product. False and R untouched
// when a or b is zero or they are parallel.
bool rotation_from_axes(Vec3 a, Vec3 b, Mat3& R);

// Third column n normalised, the others its plane space. False for a zero n.
bool rotation_from_z_axis(Vec3 n, Mat3& R);

// The nearest-by-rows rotation: row 0 keeps its direction, row 1 its half plane, row 2 is their product, so a
// reflection does not survive. False and R untouched for degenerate rows.
bool orthonormalize(Mat3& R);

// Whether its rows are orthonormal, each product within the tolerance, and it is no reflection.
bool is_rotation(const Mat3& R, Real tolerance);

// Orthonormalises what a program gives as a rotation: one that is, up to rounding in single precision, stays as it is.
bool make_rotation(Mat3& R);

// dq/dt of an orientation q that turns with w, given in the world: (0, w) q / 2.
Quat rate_of(Quat q, Vec3 w);

}  // namespace epode
