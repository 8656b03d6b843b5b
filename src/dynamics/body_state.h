// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step changes in a body, and the program's own switches, as part of a world's state: a word of bits
// and the numbers that these announce. A body in motion takes pose and velocities, 13 numbers; one that
// sleeps its pose alone; what watches whether it rests (auto-disable) up to 18 numbers more.
// What is left of idle steps and time where no step watches takes 3 words, if it is not that of a new world. The rotation matrix is
// left out where it is that of the quaternion, as steps leave it. Mass, rules of damping and sleep, callbacks
// and user data are none of the state.
#pragma once

#include "base/prefetch.h"
#include "base/streams/state_stream.h"
#include "dynamics/world.h"

namespace epode {

// Of orientations that a state brings. A contact's normal is that of the state, turned by R: together they stay within what a step
// allows (1e-3).
inline constexpr Real kUnitTolerance = Real(1e-4);

// Writes the numbers of a body. Returns the bits from which load_state() knows which there are.
std::uint16_t save_state(Body& body, StateStream& stream);

// Reads the numbers, and what the bits say themselves. True: the body's pose becomes another one.
bool load_state(Body& body, std::uint16_t bits, StateStream& stream);

// All that save_state() and load_state() look at.
inline void prefetch_state(const Body& body)
{
    prefetch<1>(&body), prefetch<5>(body.pos), prefetch<3>(&body.spin_excess);
}

}  // namespace epode
