// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces on bodies that sleep. A step clears the accumulators of the bodies that it moves; a sleeping body is not visited, and
// what a program adds to it in every frame (wind, buoyancy) would add up to one blow when it wakes. Such bodies are therefore in
// a list of their world, which the end of a step empties. ODE 0.16 keeps the sums.
#pragma once

#include "dynamics/world.h"

namespace epode {

void note_forces(Body& body);    // it may be asleep with a force
void forget_forces(Body& body);  // it leaves the world
void clear_sleeping_forces(World& world);

}  // namespace epode
