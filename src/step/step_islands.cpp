// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/step_islands.h"

#include <algorithm>

#include "joints/breaking.h"
#include "step/island/containment.h"
#include "step/island/displacement.h"
#include "step/island/report.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

constexpr std::size_t kFewBodies = 64;  // of a diverging island that is stepped exactly

// May what has diverged be stepped in another way?
bool may_try_again(const StepContext& context, std::span<const Island> islands)
{
    if (!context.stepper.iterates || context.world.acts_as_ode()) return false;
    const std::size_t bodies = joined(islands).bodies.size();
    return context.diverged == 0 || (context.diverged == 1 && bodies <= kFewBodies);
}

StepContext with_fallback(const StepContext& c, const IslandPlace& place)
{
    const IslandMethod& method = c.methods[std::size_t(place.first_island)];
    return with_stepper(c, *method.fallback, method.fallback_iterations);
}

// After the first divergence by the same stepper, after the second exactly.
StepContext without_impulses(const StepContext& c)
{
    StepContext context = with_stepper(c, c.diverged == 0 ? c.stepper : kExact, c.iterations);
    if (c.diverged > 0) context.methods = {};
    context.diverged = c.diverged + 1;
    return context;
}

// After bodies were thrown with a share of the corrections, with none. Contacts are noted, and begin without impulses.
StepContext with_less_correction(const StepContext& c, Real share)
{
    StepContext context = with_stepper(c, c.stepper, c.iterations);
    context.diverged = std::max(c.diverged, 1);
    context.correction = c.correction == 1 ? share : 0;
    return context;
}

void forget_impulses(const Island& island)
{
    for (Joint* joint : island.joints) {
        joint->impulse_rows = 0;
        if (joint->driven) forget_load(*joint);
    }
    for (ManifoldEdge* edge : island.manifolds) clear_impulses(*edge->manifold);
}

// The functions below return false when memory is exhausted.

bool step_again(const StepContext& context, Real correction, const Island& island, IslandPlace place,
                const Tasks& tasks, Arena& arena, const IslandRecords& records)
{
    context.undo.restore_bodies(island.bodies);
    forget_impulses(island);
    const StepContext next =
        correction < 1 ? with_less_correction(context, correction) : without_impulses(context);
    if (!step_islands(next, {&island, 1}, place, tasks, arena, records)) return false;
    for (dIslandStepReport& report : records.reports) report.fallback = true;
    return true;
}

bool step_by_fallback(const IslandRun& run, std::span<const Island> islands, const IslandRecords& records)
{
    const StepContext& context = run.context;
    context.undo.restore_bodies(run.work.island.bodies);
    context.contacts.begin_again(run.place.index);
    if (!step_islands(with_fallback(context, run.place), islands, run.place, run.tasks, run.arena, records))
        return false;
    if (!run.reports.empty()) run.reports[0].factorisations += run.solved.factorisations;
    return true;
}

// The parts of a run that have been set aside.
bool step_those_aside(const IslandRun& run, std::span<const Island> islands, const IslandRecords& records)
{
    for (std::size_t i = 0; i < run.set_aside.size(); ++i) {
        if (!run.set_aside[i].is) continue;
        const IslandPlace& at = run.place;
        const IslandPlace own{at.index, at.draw, at.first_contact, at.first_island + int(i)};
        const auto part = [i](auto all) { return all.empty() ? all : all.subspan(i, 1); };
        if (!step_again(run.context, run.set_aside[i].correction, islands[i], own, run.tasks, run.arena,
                        {part(records.reports), part(records.ledgers)}))
            return false;
    }
    return true;
}

}  // namespace

bool step_islands(const StepContext& context, std::span<const Island> islands, IslandPlace place,
                  const Tasks& tasks, Arena& arena, const IslandRecords& records)
{
    Arena::Scope scope(arena);
    const std::span<dIslandStepReport> reports = records.reports;
    for (std::size_t i = 0; i < reports.size(); ++i) begin_report(context.world, islands[i], reports[i]);
    const bool tries_again = may_try_again(context, islands);
    IslandRun run(context, islands, place, tries_again, tasks, records, arena);
    const Outcome outcome = context.stepper.step(run);
    if (outcome == Outcome::kNoMemory) return false;
    if (outcome == Outcome::kGaveUp) return step_by_fallback(run, islands, records);
    if (outcome == Outcome::kRefused) {
        const Real correction = run.correction_of_all;
        if (tries_again || correction < 1)
            return step_again(context, correction, islands.front(), place, tasks, arena, records);
        contain_island(run);
    }
    if (outcome == Outcome::kMade) set_displaced_aside(run, context.stepper.iterates);
    if (run.ledger.wanted()) run.ledger.end();
    for (std::size_t i = 0; i < reports.size(); ++i) end_report(context.world, islands[i], reports[i]);
    return step_those_aside(run, islands, records) && !arena.failed();
}

}  // namespace epode
