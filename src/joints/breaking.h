// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that break. What a joint exerts on body 1 in a step of size h, with impulses p,
//
//   force = |sum p lin1| / h,   torque = |sum p (ang1 - r1 x lin1)| / h,   r1: from the centre to the anchor,
//
// is compared with its limits when the whole step has been made and can no longer be taken back; the joint is
// then disabled, which the next step sees. Order does not matter, so threads do not.
#pragma once

#include "dynamics/joint_drives.h"
#include "rows/row_system.h"

namespace epode {

// Of a joint that is `driven`, before a step and for each solution of its island in it.
inline void forget_load(Joint& joint)
{
    drives_of(joint).limits.linear = drives_of(joint).limits.angular = {};
}
void add_load(Joint& joint, const RowBlock& block, const RowSystem& system);

// At the end of a step of size h. No load outlives its step, for the joint's island may not be in the next one,
// but that of a joint that broke: events tell it.
void break_joints(World& world, Real h);
// Of a step that is taken back.
void forget_loads(World& world);

}  // namespace epode
