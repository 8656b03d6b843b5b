// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An exact step of an island of robots in joint coordinates (dWorldSetJointCoordinates): solve/tree for velocities, step/island/tree for
// poses. An island is stepped so if its joints are hinges, sliders, balls and fixed ones that make no loops and are closed to the
// tolerance of the projection, rigid but for their drives and stops, if the step resolves the swinging of its light links and the turns of
// its bodies; all other islands in the way of exact.cpp.
#pragma once

#include "step/island/island_run.h"

namespace epode {

enum class TreeOutcome { kMade, kRefused, kNotInTree, kNoMemory };

// Before the island is assembled: false, if it is none for certain.
bool may_be_tree(const IslandRun& run);

// An island that has been assembled with ProblemForm::keeps_momentum, with its warm start. kNotInTree: nothing has changed but v* and the
// impulses to start from.
TreeOutcome step_in_tree(IslandRun& run);

}  // namespace epode
