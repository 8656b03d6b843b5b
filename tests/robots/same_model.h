// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What differs between two models: of all that a file can say, in words. Numbers agree within 1e-9 of the larger, lengths
// within 1e-9 m, limits from 1e9 on are none.
#pragma once

#include <string>
#include <vector>

#include "robots/model.h"

namespace epode::robots {

std::vector<std::string> differences(const RobotModel& a, const RobotModel& b);

}  // namespace epode::robots
