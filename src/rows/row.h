// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One scalar constraint as a joint states it: facts, no policy.
//
//   J v = lin1.v1 + ang1.w1 + lin2.v2 + ang2.w2     relative velocity along the row
//   error                                           position error; positive asks for J v > 0
//   speed                                           target J v in addition to the correction of the error
//   lo <= lambda <= hi                              bounds of the constraint force (N or N m)
//
// rows/policy.h makes from this what a stepper solves:  J v + (cfm/h)(h lambda) = c, where c = min(erp/h *
// error + speed, cap), and not less than the restitution velocity if there is one. ODE's joints write c
// directly. Keeping error and rate apart lets one text of a joint serve steppers that treat position errors
// differently (idea: MuJoCo's constraint rows, ODE's getInfo2).
#pragma once

#include "math/vec.h"

namespace epode {

enum class RowKind : unsigned char {
    kLock,      // equality constraint of a joint
    kLimit,     // bounded constraint: stop or motor
    kNormal,    // contact normal, lambda >= 0
    kFriction,  // bounded by a share of another row's force, or by a constant
};

struct Jacobian {
    Vec3 lin1, ang1, lin2, ang2;
};

// What pulls along a row by physical quantities, whatever the step h is (rows/policy.h makes numbers of it):
//   lambda = force + stiffness error + damping (velocity - w') + inertia (w - w')/h,    w' = J v after h
// at the place that w' leads to, so the spring is implicit: error' = error - h w'.
struct RowDrive {
    Real stiffness = 0, damping = 0, inertia = 0;
    Real force = 0, velocity = 0;
    Real rate = 0;  // w, J v at the beginning of the step or substep
};

struct Row : Jacobian {
    Real error = 0;
    Real erp = 0;  // share of the error to remove in one step; 0 for motors, which have no position
    Real cfm = 0;  // compliance: velocity per force times h (ODE's CFM)
    Real speed = 0;
    Real cap = kInf;                // upper limit of c before restitution
    Real restitution_velocity = 0;  // target J v after an impact; used if `has_restitution`
    Real lo = -kInf, hi = kInf;
    int parent = -1;  // row of the same joint whose force times `hi` bounds this row; -1: constant bounds
    RowKind kind = RowKind::kLock;
    bool has_restitution = false;
    bool soft = false;                // the user chose erp or cfm for this row: use them literally
    bool given = false;               // the error comes from the program: the pose does not determine it
    const RowDrive* drive = nullptr;  // replaces erp, cfm and speed
};

inline constexpr int kMaxJointRows = 6;  // of a joint's type, without drives
inline constexpr int kMaxAxes = 3;       // of a joint
inline constexpr int kMaxDriveRows = 3 * kMaxAxes;
inline constexpr int kMaxBlockRows = kMaxJointRows + kMaxDriveRows;

// From the centres of the bodies to a contact point, or to a joint's anchor, world frame.
struct ContactArms {
    Vec3 r1, r2;
};

// What is known about the Jacobians of a joint's rows, so that solvers need not store twelve numbers per row.
enum class RowForm : unsigned char {
    kFree,    // nothing is known
    kPoint,   // rows 0 to 2 move the points at the arms apart along x, y, z; the others turn body 1 against
              // body 2 about an axis: [ 0, a, 0, -a ]
    kTurned,  // the same along three other directions, perpendicular to one another
};

}  // namespace epode
