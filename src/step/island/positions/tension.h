// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What loaded joints add to the inertia of the bodies that they hold.
#pragma once

#include "step/island/problem/assemble.h"

namespace epode {

// The largest square of a swing's frequency times h that a solution can follow: of one that solves the joints of an island to the end, and of
// sweeps that leave off before.
inline constexpr Real kResolvedExactly = 3, kResolvedBySweeps = 1;

// Raises the inertia of `bodies`, which are those of the island in its order, where the impulses that its
// joints remember of the last step or substep of length h are too stiff for it. Returns how many it has raised; marks
// them in `marks`, if that is not empty. Out of memory: nothing is raised.
int add_tension(const IslandWork& work, std::span<SolverBody> bodies, Real h, Real resolved, Arena& arena,
                std::span<bool> marks = {});

}  // namespace epode
