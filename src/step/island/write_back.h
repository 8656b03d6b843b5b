// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a solved island back to what the user holds.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

// True when every velocity and impulse of the part (of the whole, when there are no parts) is a usable
// number.
bool sound(const RowSystem& system, int part, const Tasks& tasks = Tasks(1));

// Velocities to the bodies, impulses and feedback to the joints.
void write_back(const IslandWork& work, const Tasks& tasks);
// Impulses and feedback once more, where impulses have changed since.
void write_joints_again(const IslandWork& work);

}  // namespace epode
