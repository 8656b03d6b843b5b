// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Merges links that are fixed to their parents: masses add up, shapes move over, the names stay as frames.
#pragma once

#include "robots/model.h"

namespace epode::robots {

void merge_fixed_links(RobotModel& model);

}  // namespace epode::robots
