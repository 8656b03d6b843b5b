// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which bodies and joints a step looks at. A body is active from the moment it wakes until the end of the
// step in which it is found asleep; a joint until a step finds that none of its bodies is. What is not active
// costs a step nothing: it is reached only through what is active, and then becomes active itself.
#pragma once

#include "dynamics/world.h"

namespace epode {

inline bool is_active(const Body& body) { return body.world->bodies.is_active(body); }

void activate(Body& body);  // and its joints
void deactivate(Body& body);

void activate_all(World& world);

// Makes active the bodies in world.reached, which it empties, and all that acting joints connect with them.
// False: out of memory.
[[nodiscard]] bool activate_reached(World& world);

}  // namespace epode
