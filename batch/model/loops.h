// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Loops, and what they widen: a row that moves one of their dofs moves all of them (lanes/loops.h).
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

void add_loops(BatchModel& out, const robots::RobotModel& model);
// Those dofs, followed by the loops' others if it has one of theirs.
std::vector<int> widened(const BatchModel& model, std::vector<int> dofs);
// Where the loops' dofs stand among these, in `places`; -1: they do not.
int add_places(BatchModel& out, const std::vector<int>& dofs);
// Supports of limits, dry friction and servos that loops widen.
void widen_dofs(BatchModel& out);

}  // namespace epode::batch
