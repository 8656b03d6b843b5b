// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The stops of a joint, asked by the public functions of its type.
#pragma once

#include <ode/ode.h>

#include "view/session.h"

namespace epode::view {

// One for each freedom of hinges, sliders, universal and hinge-2 joints and pistons that has a stop.
std::vector<Limit> limits_of(dJointID joint);

}  // namespace epode::view
