// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps one island from forces to poses, or several small ones at once, which together fill the SIMD lanes. A
// call reads and writes its own bodies, joints and contacts only, so islands may be stepped in any order and
// concurrently.
#pragma once

#include "dynamics/island.h"
#include "dynamics/world.h"
#include "solve/solver.h"
#include "step/common/contact_cache.h"
#include "step/common/island_method.h"
#include "step/common/runaway.h"
#include "step/common/undo.h"

namespace epode {

struct StepContext {
    World& world;
    const Solver& solver;
    Real h;
    int iterations;
    ContactCache& contacts;
    SymbolicCache& symbolic_cache;
    StepUndo& undo;
    Runaways& runaways;
    bool manages_contacts;            // the world has world-managed contacts
    std::span<IslandMethod> methods;  // by island; empty: all have this solver, and nothing is noted
    // Solutions of the island that have diverged in this step: more than none start from no impulses.
    int diverged = 0;
};

struct IslandPlace {
    int index;          // of the group
    int draw;           // part of the random seed, whatever else has been grouped
    int first_contact;  // its first ticket in the contact cache: one per joint
    int first_island;   // index of the group's first island
};

// What is wanted: one for each island, or none.
struct IslandRecords {
    std::span<dIslandStepReport> reports;
    std::span<dEnergyLedger> ledgers;
};

// Computes velocities, impulses, feedback and poses of the islands, which are consecutive in the arrays of
// all bodies and joints; more than one only if the solver supports parts. An island whose solution is not
// finite is contained: it keeps its velocities, its constraints exert nothing, and other islands are
// unaffected. One whose sweeps diverge (divergence.h) is solved again without the impulses of the last step, then
// exactly if it is small, else contained. False: out of memory; the bodies are then half stepped, and the caller must restore them.
[[nodiscard]] bool step_islands(const StepContext& context, std::span<const Island> islands,
                                IslandPlace place, const Tasks& tasks, Arena& arena,
                                const IslandRecords& records);

// Consecutive islands as one.
Island joined(std::span<const Island> islands);

}  // namespace epode
