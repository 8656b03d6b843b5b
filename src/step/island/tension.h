// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What loaded joints add to the inertia of the bodies that they hold.
#pragma once

#include "step/island/assemble.h"

namespace epode {

// Raises the inertia of `bodies`, which are those of the island in its order, where the impulses that its
// joints remember of the last step or substep of length h are too stiff for it; true: of some it has. Out of memory: nothing is raised.
bool add_tension(const IslandWork& work, std::span<SolverBody> bodies, Real h, Arena& arena);

}  // namespace epode
