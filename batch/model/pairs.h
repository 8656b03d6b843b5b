// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

// All pairs of shapes that may touch, by the model's own filters, with their slots and supports.
void add_pairs(BatchModel& out, const robots::Prepared& prepared);

}  // namespace epode::batch
