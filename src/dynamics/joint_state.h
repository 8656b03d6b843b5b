// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A joint's part of a world's state: what a step changes in it, and the program's settings of motors, stops
// and softness. These are bits, the impulses of the last step, and what the joint's type adds
// (JointType::state). Anchors and axes do not belong to it.
#pragma once

#include "base/streams/state_stream.h"
#include "dynamics/world.h"

namespace epode {

// The bits of a joint. state() reads the number of impulses from them.
std::uint8_t state_bits(const Joint& joint);

void state(Joint& joint, std::uint8_t bits, StateStream& stream);

}  // namespace epode
