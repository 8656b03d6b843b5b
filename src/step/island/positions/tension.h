// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What loaded joints add to the inertia of the bodies that they hold.
#pragma once

#include <span>

#include "step/island/problem/assemble.h"

namespace epode {

// The largest square of a swing's frequency times h that a solution can follow: of one that solves the joints of an island to the end, and of
// sweeps that leave off before.
inline constexpr Real kResolvedExactly = 3, kResolvedBySweeps = 1;

// Of a body, sum S of what loads it (tension.cpp), with the number of joints that do: one at the end of an arm swings about its joint, with
// the inertia m r^2 that its mass has there, and is no link.
struct Swing {
    Sym3 S;
    Sym3 at_arms;  // the same about what is at right angles to the levers
    int loads;
    bool is_link() const { return loads > 1; }
};

// By body of the island, where the impulses that its joints remember of the last step or substep are about half of what would raise an
// inertia; empty: no body's are, or out of memory.
std::span<const Swing> find_swings(const IslandWork& work, Real h, Real resolved, Arena& arena);

// Raises the inertia of `bodies`, which are those of the island in its order, where the impulses that its
// joints remember of the last step or substep of length h are too stiff for it. Returns how many it has raised; marks
// them in `marks`, if that is not empty. Out of memory: nothing is raised.
int add_tension(const IslandWork& work, std::span<SolverBody> bodies, Real h, Real resolved, Arena& arena,
                std::span<bool> marks = {});

}  // namespace epode
