// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Positions after the step: joints are closed and penetrations removed at the poses that the step has
// reached.
#pragma once

#include "solve/exact/factor/symbolic_cache.h"
#include "step/island/problem/assemble.h"
#include "tasks/tasks.h"

namespace epode {

struct ProjectionReport {
    int iterations = 0;
    double error = 0;   // worst left, relative to the levers
    bool open = false;  // above the tolerance still
};

// With a projection to follow, velocities need not push bodies out of contacts and back from stops.
void leave_depth_to_projection(const World& world, const IslandWork& work);

// The island's poses have been advanced by h. Out of memory: all stays.
ProjectionReport project_poses(const World& world, const IslandWork& work, const Tasks& tasks,
                               SymbolicCache& symbolic_cache, Arena& arena);

}  // namespace epode
