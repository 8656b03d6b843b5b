// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One island from forces to poses, or several at once: small ones fill each other's lanes. It reads and
// writes its own bodies, joints and contacts only, so islands may be stepped in any order and at the same
// time.
#pragma once

#include "dynamics/island.h"
#include "dynamics/world.h"
#include "solve/solver.h"
#include "step/contact_cache.h"
#include "step/undo.h"

namespace epode {

struct StepContext {
    World& world;
    const Solver& solver;
    Real h;
    int iterations;
    ContactCache& contacts;
    SymbolicCache& symbolic_cache;
    StepUndo& undo;
    bool manages_contacts;          // the world does
    std::span<int> factorisations;  // by island, if wanted
};

struct IslandPlace {
    int index;          // of the work: part of the seed
    int first_contact;  // its room in the contact cache: one entry per joint
    int first_island;   // of the islands
};

// Velocities, impulses, feedback and poses of the islands, which lie side by side in the arrays of all bodies
// and joints; more than one only if the solver knows of parts. An island whose answer is not a number is
// contained: it keeps its velocities, its constraints exert nothing, and the others never notice. False: out
// of memory; the island's bodies are in no state to be seen then.
// `reports`: one for each island, or none.
[[nodiscard]] bool step_islands(const StepContext& context, std::span<const Island> islands,
                                IslandPlace place, const Tasks& tasks, Arena& arena,
                                std::span<dIslandStepReport> reports);

// Islands that lie side by side, as one.
Island joined(std::span<const Island> islands);

}  // namespace epode
