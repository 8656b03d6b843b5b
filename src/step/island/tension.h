// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What loaded joints add to the inertia of the bodies that they hold.
#pragma once

#include "step/island/assemble.h"

namespace epode {

// Raises the inertia of `bodies`, which are those of the island in its order, where the forces that its
// joints remember are too stiff for the step. Out of memory: nothing is raised.
void add_tension(const IslandWork& work, std::span<SolverBody> bodies, Arena& arena);

}  // namespace epode
