// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include <string>

#include "robots/model.h"

namespace epode::batch {

// Why there can be no batch of the model; empty: there can. Pairs of shapes are judged where they are made (pairs.h).
std::string refusal_of(const robots::RobotModel& model);

}  // namespace epode::batch
