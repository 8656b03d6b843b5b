// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands: bodies connected by acting joints, which must be solved together and nothing else. The static
// world does not connect; kinematic bodies do, as in ODE. Sleeping ones that they reach belong to them.
#pragma once

#include <span>

#include "base/arena.h"
#include "dynamics/world.h"

namespace epode {

struct Island {
    std::span<Body*> bodies;
    std::span<Joint*> joints;
};

// Writes each awake body's place in its island to `island_index`. False: out of memory.
bool find_islands(World& world, Arena& arena, std::span<Island>& islands);

}  // namespace epode
