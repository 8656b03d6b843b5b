// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStep: forces, one problem of the whole step that is solved exactly (solve/exact), poses. Where projection is asked for, joints
// are closed by the impulses of the step and errors of position that are left removed after it (island/positions); else poses
// close stops that would throw a joint. Where substeps are asked for, the same n times (exact_substeps.h).
#include <optional>

#include "solve/common/work_meter.h"
#include "step/island/containment.h"
#include "step/island/positions/shake.h"
#include "step/island/positions/stops.h"
#include "step/island/positions/tension.h"
#include "step/island/report.h"
#include "step/island/warm_start.h"
#include "step/island/write_back.h"
#include "step/steppers/exact_substeps.h"
#include "step/steppers/exact_tree.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

constexpr int kLarge = 256;                 // joints of an island that all workers solve together
constexpr double kLeftToProjection = 1e-9;  // residual; the projection corrects smaller errors of position

bool solve_stops_exactly(RowSystem& system, const World&, const Tasks& tasks, Arena& arena)
{
    SolveReport report;
    return solve_exactly(system, {.tasks = tasks}, arena, report);
}

ProblemForm form_in(const World& world, bool in_tree = false)
{
    return {.inertia = true, .coulomb = world.friction_cone, .keeps_momentum = in_tree, .shares_load = true};
}

ExactSettings settings_for(const IslandRun& run)
{
    ExactSettings settings{.want_residual = !run.reports.empty(), .tasks = run.tasks};
    if (run.world.projection_iterations > 0) settings.refine_above = kLeftToProjection;
    settings.symbolic_cache = &run.context.symbolic_cache;
    return settings;
}

// Solves it with no more work than its method may take, and notes what it took.
bool solve_in_budget(IslandRun& run)
{
    ExactSettings settings = settings_for(run);
    if (run.methods().empty()) return solve_exactly(run.work.system, settings, run.arena, run.solved);
    IslandMethod& method = run.methods().front();
    WorkMeter meter{.limit = method.max_work};
    settings.work = &meter;
    const bool solved = solve_exactly(run.work.system, settings, run.arena, run.solved);
    method.work = meter.spent, method.gave_up = run.solved.gave_up;
    return solved;
}

ProjectionReport advance_and_project(IslandRun& run)
{
    SymbolicCache& cache = run.context.symbolic_cache;
    if (run.raised > 0)
        advance_poses(run.world, run.work, run.context.h);
    else if (advance_closing(run.world, run.work, run.tasks, cache, run.arena))
        write_joints_again(run.work);
    ProjectionReport projected;
    run.correct_poses([&] { projected = project_poses(run.world, run.work, run.tasks, cache, run.arena); });
    return projected;
}

void report_projected(IslandRun& run, const ProjectionReport& projected)
{
    for (dIslandStepReport& report : run.reports) report_projection(projected, report);
}

void advance_and_close_stops(IslandRun& run, bool closes_stops)
{
    advance_poses(run.world, run.work, run.context.h);
    if (closes_stops)
        run.correct_poses(
            [&] { close_stops(run.world, run.work, solve_stops_exactly, run.tasks, run.arena); });
}

// Poses that corrections have carried away are moved by velocities alone.
bool projects_poses(const IslandRun& run)
{
    return run.world.projection_iterations > 0 && run.context.correction == 1;
}

std::optional<Outcome> try_tree(IslandRun& run)
{
    switch (step_in_tree(run)) {
        case TreeOutcome::kMade:
            return Outcome::kMade;
        case TreeOutcome::kRefused:
            return Outcome::kRefused;
        case TreeOutcome::kNoMemory:
            return Outcome::kNoMemory;
        case TreeOutcome::kNotInTree:
            break;
    }
    return std::nullopt;
}

// What the step has become in joint coordinates; none: rows must make it, and the step begins again as without the attempt.
std::optional<Outcome> try_tree_first(IslandRun& run, bool closes_stops)
{
    Arena::Scope scope(run.arena);
    const std::span<RowNumbers> numbers = run.work.system.numbers;
    const auto begun = run.arena.take<Real>(int(numbers.size()));
    if (run.arena.failed()) return Outcome::kNoMemory;
    for (std::size_t i = 0; i < begun.size(); ++i) begun[i] = numbers[i].p;
    if (!closes_stops)
        if (const std::optional<Outcome> outcome = try_tree(run)) return outcome;
    for (std::size_t i = 0; i < begun.size(); ++i) numbers[i].p = begun[i];
    load_all_pushed(run.world, run.context.h, run.work);
    return std::nullopt;
}

Outcome step_once(IslandRun& run)
{
    IslandWork& work = run.work;
    const bool projects = projects_poses(run), may_move = run.context.correction == 1;
    const bool in_tree = may_be_tree(run);
    if (!run.begin(form_in(run.world, in_tree), run.context.h)) return Outcome::kNoMemory;
    if (projects) leave_depth_to_projection(run.world, work);
    const bool closes_stops = !projects && may_move && leave_stops_to_poses(run.world, work.system);
    load_warm_start(run, {});
    if (in_tree)
        if (const std::optional<Outcome> outcome = try_tree_first(run, closes_stops)) return *outcome;
    if (!run.raise_inertias(work.system.h, kResolvedExactly)) return Outcome::kNoMemory;
    const bool solved = solve_in_budget(run);
    if (run.arena.failed()) return Outcome::kNoMemory;
    if (run.solved.gave_up) return Outcome::kGaveUp;
    const bool sane = solved && run.is_sound();
    run.report_solution();
    if (!sane) return Outcome::kRefused;
    run.report_raised();
    contain_unsound(run, false, [](int, bool) {});
    run.add_solution_to_ledger(false);
    write_back(work, run.tasks);
    run.add_forces_to_ledger();
    keep_impulses(run, {});
    if (projects)
        report_projected(run, advance_and_project(run));
    else
        advance_and_close_stops(run, closes_stops);
    return Outcome::kMade;
}

Outcome step_in_exact_substeps(IslandRun& run)
{
    const int n = run.world.exact_substeps;
    const WarmStart start{.solutions = n};
    ExactSubsteps substeps(run, form_in(run.world), n);
    if (!substeps.begin() || !run.begin(form_in(run.world), substeps.substep())) return Outcome::kNoMemory;
    substeps.map(run.work.system);
    if (!run.raise_inertias(run.work.system.h, kResolvedExactly)) return Outcome::kNoMemory;
    if (run.world.projection_iterations > 0) leave_depth_to_projection(run.world, run.work);
    load_warm_start(run, start);
    substeps.kick(run.world.warm_starting);
    ProjectionReport projected;
    const ExactSettings settings = settings_for(run);
    const bool sane = solve_exactly(run.work.system, settings, run.arena, run.solved) && run.is_sound() &&
                      substeps.run(settings, projected);
    if (run.arena.failed()) return Outcome::kNoMemory;
    run.report_solution();
    if (!sane) return substeps.undo(), Outcome::kRefused;
    run.add_forces_to_ledger();
    keep_impulses(run, start);
    if (run.world.projection_iterations > 0) report_projected(run, projected);
    return Outcome::kMade;
}

Outcome step_exactly(IslandRun& run)
{
    return run.world.exact_substeps > 1 && run.context.correction == 1 ? step_in_exact_substeps(run)
                                                                       : step_once(run);
}

bool has_many_joints(const Island& island) { return int(island.joints.size()) >= kLarge; }

}  // namespace

const Stepper kExact{.name = "exact", .step = step_exactly, .is_large = has_many_joints};

}  // namespace epode
