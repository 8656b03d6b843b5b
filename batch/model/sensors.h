// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

// Those that the file names, in its order; what a batch does not compute has no values. sums: which one is each tendon's, -1: none.
void add_sensors(BatchModel& out, const robots::RobotModel& model, const std::vector<int>& sums);

}  // namespace epode::batch
