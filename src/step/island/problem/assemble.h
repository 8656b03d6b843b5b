// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An island as joints and bodies becomes an island as rows and numbers.
#pragma once

#include "base/arena.h"
#include "dynamics/island.h"
#include "rows/row_system.h"
#include "rows/row_writer.h"
#include "solve/solver.h"
#include "step/common/undo.h"

namespace epode {

// An island under work: what the solver sees, and who is behind it. Several small islands may be worked on as
// one, if the solver knows of parts.
struct IslandWork {
    Island island;                    // all members together
    std::span<const Island> members;  // at least one
    std::span<Joint*> joints;       // of the first blocks of the system: those that gave rows; then manifolds
    std::span<Joint*> contacts;     // parallel to system.joint_contacts.points
    bool contact_feedback = false;  // has any of them?
    RowSystem system;
};

StepInfo step_info(const World& world, Real h);

// Of work.island: gravity and the joints' own forces enter the bodies' accumulators, rows and numbers are
// written, and the SolverBodies hold v: the present velocities if the solver makes inner steps, else v* after
// all forces. `undo` has the bodies before anything of them changes; null: it has. False: out of memory.
bool assemble(World& world, Real h, const Solver& solver, const Tasks& tasks, Arena& arena, IslandWork& work,
              StepUndo* undo);

// The terms of a coupling's block at the present poses.
void place_terms(std::span<const BodyTerm> from, const RowSystem& system, const RowBlock& block);

inline constexpr int kLinesOfBody = 8;  // of the cache: all that a step reads of one

// For one body; substeps do the same for eight bodies at once (solve/substeps/body_kernels.inc).
void load_inertia(const Body& body, SolverBody& out);  // the inverse only
void load_velocity(const Body& body, SolverBody& out);
// The present velocity with h M^-1 (accumulated + gyroscopic) on top; behind the inertia.
void load_pushed(const Body& body, Real h, SolverBody& out);
void load_pushed_exactly(Body& body, Real h, SolverBody& out);  // with exact rotation

}  // namespace epode
