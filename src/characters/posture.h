// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where a character's feet are, and its height. The feet are a skin below the shape, so that they are on level
// ground when the shape keeps its gap.
#pragma once

#include "collide/character.h"

namespace epode {

Vec3 foot_of(const Geom& geom);
void put_foot(Geom& geom, Vec3 foot);
// It stands on nothing, and has not moved.
void forget_ground(Character& character);
// With the feet where they are. False: there is no room, or no memory, and nothing has changed.
[[nodiscard]] bool change_height(Geom& geom, Real height);

}  // namespace epode
