// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step changes in a body, and the program's own switches, as part of a world's state: a word of bits
// and the numbers that these announce. A body in motion takes pose and velocities, 13 numbers; one that
// sleeps its pose alone; what watches whether it rests (auto-disable) up to 18 numbers more. The rotation matrix is
// left out where it is that of the quaternion, as steps leave it. Mass, rules of damping and sleep, callbacks
// and user data are none of the state.
#pragma once

#include "base/streams/state_stream.h"
#include "dynamics/world.h"

namespace epode {

// The bits of a body, from which state() knows which numbers there are.
std::uint16_t state_bits(const Body& body);

// The numbers, and what the bits say themselves. True: the body's pose becomes another one.
bool state(Body& body, std::uint16_t bits, StateStream& stream);

}  // namespace epode
