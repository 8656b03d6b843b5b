// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Gravity, falls and jumps for a character (dCharacterWalk). In the air, with momentum v0 at the beginning of
// a step, it moves by v0 h - g h^2 / 2 and has v0 - g h at its end, so that a jump is as high and as long as
// its parabola, whatever h. In the horizontal, the momentum approaches what is asked for, relative to what the
// character has jumped from, at most with the air acceleration.
#pragma once

#include "collide/character.h"

namespace epode {

// False: out of memory, with nothing moved.
[[nodiscard]] bool walk(Geom& geom, Vec3 velocity, Real jump_speed, Real h);
[[nodiscard]] bool move(Geom& geom, Vec3 velocity, Real h);

}  // namespace epode
