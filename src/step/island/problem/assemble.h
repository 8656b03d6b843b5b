// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An island as joints and bodies becomes an island as rows and numbers.
#pragma once

#include "base/arena.h"
#include "dynamics/island.h"
#include "rows/row_system.h"
#include "rows/row_writer.h"
#include "step/common/undo.h"
#include "tasks/tasks.h"

namespace epode {

// An island under work: what the solver sees, and who is behind it. Several small islands may be worked on as
// one, if the solver knows of parts.
struct IslandWork {
    Island island;                    // all members together
    std::span<const Island> members;  // at least one
    std::span<Joint*> joints;       // of the first blocks of the system: those that gave rows; then manifolds
    std::span<Joint*> contacts;     // parallel to system.joint_contacts.points
    bool contact_feedback = false;  // has any of them?
    Real correction = 1;  // share of the errors of positions that is corrected (island/divergence.h)
    RowSystem system;
};

// What the problem of an island must look like.
struct ProblemForm {
    bool joint_manifolds = false;    // contact joints without feedback become manifolds, else rows
    bool contact_manifolds = false;  // world-managed contacts stay manifolds, else they become rows
    bool cones = false;              // friction may be bounded by an ellipse
    bool inertia = false;            // SolverBody::mass and inertia, not only their inverses
    bool coulomb = false;         // friction is bounded by its present normal impulse (solve/exact/coulomb.h)
    bool keeps_depth = false;     // islands that settle keep a depth of contacts
    bool keeps_momentum = false;  // v* without gyroscopic effects: M v* is the momentum after all forces
    bool shares_load =
        false;  // world-managed contacts that hardly correct do not: they share what they carry
    bool has_substeps = false;  // bodies begin with their present velocities; forces follow in substeps
};

StepInfo step_info(const World& world, Real h);

// Of work.island: gravity and the joints' own forces enter the bodies' accumulators, rows and numbers are
// written, and the SolverBodies hold v: the present velocities if substeps are made, else v* after
// all forces. `undo` has the bodies before anything of them changes; null: it has. False: out of memory.
bool assemble(World& world, Real h, const ProblemForm& form, const Tasks& tasks, Arena& arena,
              IslandWork& work, StepUndo* undo);

// The terms of a coupling's block at the present poses.
void place_terms(std::span<const BodyTerm> from, const RowSystem& system, const RowBlock& block);

inline constexpr int kLinesOfBody = 8;  // of the cache: all that a step reads of one

// For one body; substeps do the same for eight bodies at once (solve/substeps/body_kernels.inc).
void load_inertia(const Body& body, SolverBody& out);  // the inverse only
void load_velocity(const Body& body, SolverBody& out);
// The present velocity with h M^-1 (accumulated + gyroscopic) on top; behind the inertia.
void load_pushed(const Body& body, Real h, SolverBody& out);
void load_pushed_exactly(Body& body, Real h, SolverBody& out);  // with exact rotation
// v* of an island that was assembled with keeps_momentum, as they are without.
void load_all_pushed(const World& world, Real h, IslandWork& work);

}  // namespace epode
