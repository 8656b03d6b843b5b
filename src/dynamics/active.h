// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which bodies and joints a step looks at. A body is active from the moment it wakes until the end of the
// step in which it is found asleep; a joint is active if one of its bodies is. What is not active costs a
// step nothing: it is reached only through what is active, and then becomes active itself.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline bool is_active(const Body& body) { return body.world->bodies.is_active(body); }

// Both ways with the body's joints. Costs a look at each of them, and at the bodies behind them.
void activate(Body& body);
void deactivate(Body& body);

void activate_all(World& world);

// The joint has come to its bodies, or is about to leave them.
void joint_attached(Joint& joint);
void joint_detached(Joint& joint);

// Makes active the bodies in world.reached, which it empties, and all that acting joints connect with them.
// False: out of memory.
[[nodiscard]] bool activate_reached(World& world);

}  // namespace epode
