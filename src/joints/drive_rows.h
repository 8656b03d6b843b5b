// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Positions of joint axes, and the rows of a joint including those of its drives.
#pragma once

#include "dynamics/joint_drives.h"
#include "rows/row_system.h"
#include "rows/row_writer.h"

namespace epode {

// The number of axes that the joint has now; 0 for types without axes.
inline int axis_count(const Joint& joint) { return joint.type->axes ? joint.type->axes(joint) : 0; }

// For an attached joint: the position as the program reads it, with the turns that are counted.
Real axis_position(const Joint& joint, int axis);
Real axis_rate(const Joint& joint, int axis);
// Whether an angle counts its turns without stops too, from where it is.
void set_continuous(Joint& joint, int axis, bool continuous);

// Stores the forces of the drives after the step has been solved.
void store_drive_forces(Joint& joint, const RowBlock& block, const RowSystem& system);

void emit_drives(Joint& joint, RowWriter& out);

// The rows of the joint's type, then those of its drives.
inline void emit_joint(Joint& joint, RowWriter& out)
{
    joint.type->emit(joint, out);
    if (joint.driven) emit_drives(joint, out);
}

}  // namespace epode
