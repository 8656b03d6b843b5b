// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step changes in a joint, and the program's own settings of motors, stops and softness, as part of a
// world's state: bits, the impulses of the last step, and what the joint's type adds (JointType::state).
// Anchors and axes are none of it.
#pragma once

#include "base/state_stream.h"
#include "dynamics/world.h"

namespace epode {

// The bits of a joint, from which state() knows how many impulses there are.
std::uint8_t state_bits(const Joint& joint);

void state(Joint& joint, std::uint8_t bits, StateStream& stream);

}  // namespace epode
