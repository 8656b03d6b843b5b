// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact joints as manifolds, for solvers that take them: many at a time, without rows in between.
#pragma once

#include "dynamics/joint.h"
#include "rows/joint_manifold.h"
#include "rows/row_writer.h"

namespace epode {

// Consecutive of these plain contacts (Joint::plain) of the same bodies, with the same normal and friction,
// share a manifold. `out` has capacity for as many of each as there are contacts, whose order the points keep;
// its manifolds are cut to their number.
void write_manifolds(std::span<Joint* const> contacts, const StepInfo& info, JointManifoldList& out);

// The row along its normal, but for the Jacobian; at the pose and velocities that its bodies have.
Row normal_of_contact(const Joint& joint, const StepInfo& info);

// Where a contact joint acts.
struct ContactPlace {
    Vec3 position, normal;  // into body 1
    Real depth;
};
ContactPlace place_of_contact(const Joint& joint);

}  // namespace epode
