// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How large the numbers of a robot may be: products of two are still numbers that libode takes, and those of four are
// finite, so that no dynamics of the model are not numbers.
#pragma once

#include <ode/common.h>

#include "robots/model.h"

namespace epode::robots {

constexpr double kMaxNumber = sizeof(dReal) == 8 ? 1e30 : 1e9;
// "1e30".
const char* max_number_text();

// The shortest text that is read as this number, with a point in every locale. What has no limit is the largest number:
// readers want finite ones and take such limits for none.
std::string text_of(double value);

// Limits beyond it are none: +-kInfinity. An error for each part of the model with another such number.
void judge_numbers(RobotModel& model);

}  // namespace epode::robots
