// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint of any type may have in addition: drives and breaking limits. Few joints have
// them. All of it is state or structure of the joint, except what is marked as belonging to the current step.
#pragma once

#include "dynamics/joint.h"
#include "ode/drives.h"

namespace epode {

struct AxisDrive {
    dDrive drive{};
    bool driven = false;
    Real force = 0;  // of the drive, the mean over the last step
    // Of the current step:
    RowDrive servo, rotor;  // which rows point to
    Real rate = 0;          // at the pose of the rows
    Real start_rate = 0;    // when the step began
    Real drift = 0;         // of the rate, where no force acts, m/s^2; and when the step began
    Real start_drift = 0;
    int passes = 0;           // how often the rows were written: substeps
    int servo_row = -1;       // in the joint's block; -1: none
    bool with_rotor = false;  // that row includes the rotor
};

// The load at which a joint breaks.
struct BreakLimits {
    Real force = kInf, torque = kInf;
    bool broken = false;
    std::uint64_t step = 0;  // the world's step count when it broke
    Vec3 linear, angular;    // impulse, and angular about the anchor, so far in the current step

    bool any() const { return force < kInf || torque < kInf; }
};

struct JointDrives {
    AxisDrive axis[kMaxAxes];
    BreakLimits limits;
};

// For joints with `driven` set.
inline JointDrives& drives_of(Joint& joint) { return *static_cast<LastingJoint&>(joint).drives; }
inline const JointDrives& drives_of(const Joint& joint)
{
    return *static_cast<const LastingJoint&>(joint).drives;
}

// The joint's drives, created if it has none; `joint.driven` is set then and stays set. Null: out of memory.
JointDrives* take_drives(LastingJoint& joint);

}  // namespace epode
