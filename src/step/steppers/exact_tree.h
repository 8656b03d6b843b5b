// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An exact step of an island of robots in joint coordinates (dWorldSetJointCoordinates): solve/tree for velocities, step/island/tree for
// poses. Hinges, sliders, balls and fixed joints that are rigid and closed to the tolerance of the projection become branches of trees;
// those that close loops and all others are rows over them (step/island/tree/closing_rows.h). An island is stepped so if the branches leave
// out more rows than there are such rows (in a hybrid step with a budget: also if nothing touches and few rows are left), and if the step resolves the swinging of its light links and the turns of its bodies; all
// other islands in the way of exact.cpp.
#pragma once

#include "step/island/island_run.h"

namespace epode {

// Bodies of an island with a budget, whose time in joint coordinates is not metered.
inline constexpr int kFewTreeBodies = 32;

enum class TreeOutcome { kMade, kRefused, kNotInTree, kNoMemory };

// Before the island is assembled: false, if it is none for certain.
bool may_be_tree(const IslandRun& run);

// An island that has been assembled with ProblemForm::keeps_momentum, with its warm start. kNotInTree: nothing has changed but v* and the
// impulses to start from.
TreeOutcome step_in_tree(IslandRun& run);

}  // namespace epode
