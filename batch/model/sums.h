// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

// Couplings, then tendons that are sums of coordinates, with what acts on them. Returns which sum each tendon is; -1: none.
std::vector<int> add_sums(BatchModel& out, const robots::Prepared& prepared);

}  // namespace epode::batch
