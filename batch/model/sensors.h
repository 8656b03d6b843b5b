// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

// Those that the file names, in its order; what a batch does not compute has no values.
void add_sensors(BatchModel& out, const robots::RobotModel& model);

}  // namespace epode::batch
