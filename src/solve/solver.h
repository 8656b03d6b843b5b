// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The solvers: functions from a RowSystem with numbers for the whole step (rows/policy.h, p = warm start) to velocities
// and impulses. They know no poses and no time but h; substeps have solvers of their own (substeps/substep_solver.h).
// False: out of memory, nothing usable was computed.
#pragma once

#include <cstdint>

#include "base/arena.h"
#include "ode/report.h"
#include "rows/row_system.h"
#include "tasks/tasks.h"

namespace epode {

class SymbolicCache;
struct WorkMeter;

struct SolveReport {
    dIslandMethod method = dIslandMethodNone;
    Real residual = 0;  // natural residual, relative (solve/common/residual.h)
    int iterations = 0;
    int factorisations = 0;
    bool fallback = false;
    bool gave_up = false;     // there is no answer: it would have taken more work than it may
    int unsolved_joint = -1;  // of the exact solver: a block, and how many (solve/common/stored_residual.h)
    int unsolved_joints = 0;
    Real friction_error = 0;  // of the exact solver with Coulomb's friction (solve/exact/coulomb.h), relative
};

struct ExactSettings {
    bool want_residual = false;  // costs an evaluation
    Tasks tasks{};
    // The natural residual above which the answer is refined with more digits; it always reaches 1e-9.
    double refine_above = 1e-10;
    SymbolicCache* symbolic_cache = nullptr;  // symbolic factors of earlier steps, kept by the world
    WorkMeter* work = nullptr;                // counts, and may end, the solution (solve/common/work_meter.h)
};

// Reads SolverBody::mass and inertia, not only their inverses, and wants all contacts as rows.
bool solve_exactly(RowSystem& system, const ExactSettings& settings, Arena& arena, SolveReport& report);

struct SweepSettings {
    int iterations = 20;
    Real w = Real(1.3);                   // over-relaxation
    std::uint64_t seed = 0;               // a function of world, step and island: for shuffles
    bool want_residual = false;           // costs an evaluation
    std::span<Real> part_residuals = {};  // also of each part of a system of several
};

bool solve_by_sweeps(RowSystem& system, const SweepSettings& settings, Arena& arena, SolveReport& report);
// As ODE 0.16 does. Wants all contacts as rows, and one part.
bool solve_by_shuffled_sweeps(RowSystem& system, const SweepSettings& settings, Arena& arena,
                              SolveReport& report);

}  // namespace epode
