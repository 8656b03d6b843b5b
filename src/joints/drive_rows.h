// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joint coordinates in general, and the rows of a joint with those of its drives.
#pragma once

#include "dynamics/joint_drives.h"
#include "rows/row_system.h"
#include "rows/row_writer.h"

namespace epode {

// How many axes the joint has now; 0 for types without any.
inline int axis_count(const Joint& joint) { return joint.type->axes ? joint.type->axes(joint) : 0; }

// Of an attached joint: the position in the sense of the client, turns counted where the axis is continuous.
Real axis_position(const Joint& joint, int axis);

// What the drives have exerted, when the step has been solved.
void store_drive_forces(Joint& joint, const RowBlock& block, const RowSystem& system);

void emit_drives(Joint& joint, RowWriter& out);

// The rows of the joint's type, then those of its drives.
inline void emit_joint(Joint& joint, RowWriter& out)
{
    joint.type->emit(joint, out);
    if (joint.driven) emit_drives(joint, out);
}

}  // namespace epode
