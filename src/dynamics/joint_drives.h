// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint keeps beyond its type: drives, turns, limits at which it breaks. Few joints have it. All of it
// is state or structure of the joint except what is marked as belonging to the step under way.
#pragma once

#include "dynamics/joint.h"
#include "ode/drives.h"

namespace epode {

struct AxisDrive {
    dDrive drive{};
    bool driven = false;
    bool continuous = false;  // the position counts turns
    Real reference = 0;       // of a continuous axis: the position when the last step began
    Real force = 0;           // of the drive, the mean over the last step
    // Of the step under way:
    RowDrive servo, rotor;    // that rows point to
    Real rate = 0;            // at the pose of the rows
    Real start_rate = 0;      // when the step began
    int servo_row = -1;       // in the joint's block; -1: none
    bool with_rotor = false;  // that row is the rotor's too
};

// What a joint may carry before it lets go.
struct BreakLimits {
    Real force = kInf, torque = kInf;
    bool broken = false;
    std::uint64_t step = 0;  // of the world in which it broke
    Vec3 linear, angular;    // impulse, and about the anchor, so far in the current step

    bool any() const { return force < kInf || torque < kInf; }
};

struct JointDrives {
    AxisDrive axis[kMaxAxes];
    BreakLimits limits;
};

// Of a joint that is `driven`.
inline JointDrives& drives_of(Joint& joint) { return *static_cast<LastingJoint&>(joint).drives; }
inline const JointDrives& drives_of(const Joint& joint)
{
    return *static_cast<const LastingJoint&>(joint).drives;
}

// The joint's, made if it has none; `joint.driven` then, for good. Null: out of memory.
JointDrives* take_drives(LastingJoint& joint);

}  // namespace epode
