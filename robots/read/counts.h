// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How many numbers attributes take at most. More are refused where they stand, whether the reader uses them or not: what is one too
// many is a slip that would be passed over.
#pragma once

#include "robots/read/reading.h"

namespace epode::robots {

// The attributes of one element of MJCF, as MuJoCo counts them.
void check_mjcf_counts(const Element& element, Reading& reading);
// A whole robot of URDF, but what <gazebo> says for a simulator.
void check_urdf_counts(const Element& robot, Reading& reading);

}  // namespace epode::robots
