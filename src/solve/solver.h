// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The interface of every solver: a function from a RowSystem with numbers for the whole step (rows/policy.h,
// p = warm start) to velocities and impulses. Steppers differ in this one argument.
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "ode/report.h"
#include "rows/row_system.h"
#include "tasks/tasks.h"

namespace epode {

class SymbolicCache;
struct WorkMeter;

struct SolverSettings {
    int iterations = 20;
    // The same where joints that were to be one block are swept after all (solve/substeps/tgs.cpp).
    int swept_iterations = 20;
    Real w = Real(1.3);      // over-relaxation
    std::uint64_t seed = 0;  // a function of world, step and island: for shuffles
    const Substeps* substeps = nullptr;
    bool want_residual = false;        // costs an evaluation
    std::span<Real> part_residuals;    // also of each part of a system of several
    bool contact_manifolds = false;    // the world manages contacts: islands may come with contact manifolds
    Tasks tasks;                       // for solvers with inner_tasks
    std::span<Velocity> substep_ends;  // with substeps, if wanted: gets the sum of the velocities after each
    // Exact solver: the natural residual above which it refines the answer with more digits; it always
    // reaches 1e-9.
    double refine_above = 1e-10;
    SymbolicCache* symbolic_cache = nullptr;  // symbolic factors of earlier steps, kept by the world
    WorkMeter* work = nullptr;  // exact solver: counts, and may end, the solution (solve/common/work_meter.h)
};

struct SolveReport {
    dIslandMethod method = dIslandMethodNone;
    Real residual = 0;  // natural residual, relative (solve/common/residual.h)
    int iterations = 0;
    int factorisations = 0;
    bool fallback = false;
    bool gave_up = false;     // there is no answer: it would have taken more work than it may
    int unsolved_joint = -1;  // of exact solvers: a block, and how many (solve/common/stored_residual.h)
    int unsolved_joints = 0;
    Real friction_error = 0;  // of exact solvers with Coulomb's friction (solve/exact/coulomb.h), relative
};

struct Solver {
    const char* name;
    bool substeps = false;           // advances poses itself through SolverSettings::substeps
    bool needs_inertia = false;      // reads SolverBody::mass and inertia, not only their inverses
    bool inner_tasks = false;        // has work for several workers in one large island
    bool joint_manifolds = false;    // takes RowSystem::joint_contacts and parts; others are given rows only
    bool cones = false;              // knows RowSystem::cone and manifold_friction
    bool contact_manifolds = false;  // solves RowSystem::contact_manifolds, and parts; others want rows
    bool draws = false;              // from ProcessRandom: islands are solved in order, on one thread
    Real warm_share =
        1;  // of the last step's impulses that it starts from when the world asks for warm starting
    int settling_factor =
        1;  // so many times the iterations for islands that settle; 1: its answer needs no more
    // False: out of memory, nothing usable was computed.
    bool (*solve)(RowSystem& system, const SolverSettings& settings, Arena& arena, SolveReport& report);
};

#define SOLVER(name) extern const Solver k##name;
#include "solve/solvers.inc"
#undef SOLVER

}  // namespace epode
