// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldQuickStep: forces, a fixed number of sweeps over one problem of the whole step (solve/sweeps), poses. Where stops
// would throw a joint, poses close it afterwards (island/positions/stops.h).
#include "step/island/containment.h"
#include "step/island/positions/shake.h"
#include "step/island/positions/stops.h"
#include "step/island/positions/tension.h"
#include "step/island/warm_start.h"
#include "step/island/write_back.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

using Sweeps = bool (*)(RowSystem&, const SweepSettings&, Arena&, SolveReport&);

template <Sweeps kSolve>
bool solve_stops(RowSystem& system, const World& world, const Tasks&, Arena& arena)
{
    SolveReport report;
    return kSolve(system, {.iterations = world.quick_iterations, .w = world.quick_w}, arena, report);
}

template <Sweeps kSolve>
Outcome step_by_sweeps(IslandRun& run, const ProblemForm& form, const WarmStart& start, int settling)
{
    IslandWork& work = run.work;
    if (!run.begin(form, run.context.h)) return Outcome::kNoMemory;
    if (!run.raise_inertias(work.system.h, kResolvedBySweeps)) return Outcome::kNoMemory;
    const bool closes_stops = leave_stops_to_poses(run.world, work.system);
    load_fitting_start(run, start);
    const SweepSettings settings{.iterations = run.settling_iterations(settling),
                                 .w = run.world.quick_w,
                                 .seed = run.seed(),
                                 .want_residual = !run.reports.empty(),
                                 .part_residuals = run.part_residuals};
    const bool sane = kSolve(work.system, settings, run.arena, run.solved) && run.is_sound();
    if (run.arena.failed()) return Outcome::kNoMemory;
    run.report_solution();
    if (!sane) return Outcome::kRefused;
    run.report_raised();
    contain_unsound(run, true, [](int, bool) {});
    run.add_solution_to_ledger(false);
    write_back(work, run.tasks);
    run.add_forces_to_ledger();
    keep_impulses(run, start);
    advance_poses(run.world, work, run.context.h);
    if (closes_stops)
        run.correct_poses([&] { close_stops(run.world, work, solve_stops<kSolve>, run.tasks, run.arena); });
    return Outcome::kMade;
}

Outcome step_quickly(IslandRun& run)
{
    return step_by_sweeps<solve_by_sweeps>(run, {.joint_manifolds = true, .cones = true, .keeps_depth = true},
                                           {.share = Real(0.6)}, 5);
}

Outcome step_shuffled(IslandRun& run)
{
    return step_by_sweeps<solve_by_shuffled_sweeps>(run, {}, {.share = 0}, 1);
}

// World-managed contacts become rows, which are appended after those of all joints.
Sharing quick_sharing(bool manages_contacts) { return manages_contacts ? Sharing::kFree : Sharing::kAll; }

}  // namespace

const Stepper kQuick{
    .name = "quick", .step = step_quickly, .sharing = quick_sharing, .iterates = true, .as_ode = &kShuffled};

const Stepper kShuffled{.name = "shuffled", .step = step_shuffled, .draws = true, .iterates = true};

}  // namespace epode
