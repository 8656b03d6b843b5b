// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// NAME: forces, sweeps over one problem of the whole step with all contacts as rows, poses.
#include "step/island/containment.h"
#include "step/island/positions/shake.h"
#include "step/island/positions/tension.h"
#include "step/island/warm_start.h"
#include "step/island/write_back.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

constexpr ProblemForm kFormOfNAME{.cones = true};
constexpr WarmStart kStartOfNAME{.share = Real(0.6)};

Outcome step_NAME(IslandRun& run)
{
    IslandWork& work = run.work;
    // The problem: velocities after all forces, rows, and the impulses of the last step.
    if (!run.begin(kFormOfNAME, run.context.h)) return Outcome::kNoMemory;
    if (!run.raise_inertias(work.system.h, kResolvedBySweeps)) return Outcome::kNoMemory;
    load_warm_start(run, kStartOfNAME);
    // The solution: velocities and impulses.
    const SweepSettings settings{.iterations = run.context.iterations,
                                 .w = run.world.quick_w,
                                 .seed = run.seed(),
                                 .want_residual = !run.reports.empty(),
                                 .part_residuals = run.part_residuals};
    const bool sane = solve_by_sweeps(work.system, settings, run.arena, run.solved) && run.is_sound();
    if (run.arena.failed()) return Outcome::kNoMemory;
    run.report_solution();
    if (!sane) return Outcome::kRefused;
    run.report_raised();
    contain_unsound(run, true, [](int, bool) {});
    // Back to the bodies: velocities, feedback, shares of energy, impulses for the next step, poses.
    run.add_solution_to_ledger(false);
    write_back(work, run.tasks);
    run.add_forces_to_ledger();
    keep_impulses(run, kStartOfNAME);
    advance_poses(run.world, work, run.context.h);
    return Outcome::kMade;
}

}  // namespace

const Stepper kNAME{.name = "FILE", .step = step_NAME, .iterates = true};

}  // namespace epode
