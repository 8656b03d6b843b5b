// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The stops of a joint, asked by the public functions of its type, which also tell where the joint is now.
#pragma once

#include <ode/ode.h>

#include "record/file/recording.h"

namespace epode::record {

// One for each freedom of hinges, sliders, universal, hinge-2, PR and PU joints and pistons that has a stop;
// not of a PU joint's slide, whose axis a record::Joint does not have. `number` is what they say of their
// joint.
void add_limits(dJointID joint, std::uint32_t number, std::vector<Limit>& limits);

}  // namespace epode::record
