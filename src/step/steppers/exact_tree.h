// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An exact step of an island of robots in joint coordinates (dWorldSetJointCoordinates): solve/tree for velocities, step/island/tree for
// poses. An island is stepped so if its joints are hinges, sliders, balls and fixed ones that make no loops and are closed to the
// tolerance of the projection, rigid but for their drives and stops; all other islands in the way of exact.cpp.
#pragma once

#include "step/island/island_run.h"

namespace epode {

enum class TreeOutcome { kMade, kRefused, kNotInTree, kNoMemory };

// An island that has been assembled, with its warm start. kNotInTree: nothing has changed.
TreeOutcome step_in_tree(IslandRun& run);

}  // namespace epode
