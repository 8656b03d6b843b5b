// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/island_run.h"

#include <algorithm>

#include "step/island/positions/tension.h"
#include "step/island/problem/default_softness.h"
#include "step/island/report.h"
#include "step/island/write_back.h"

namespace epode {
namespace {

constexpr int kManyIterations = 1000;  // from here on no more for settling islands

}  // namespace

StepContext with_stepper(const StepContext& c, const Stepper& stepper, int iterations)
{
    return {.world = c.world,
            .stepper = stepper,
            .h = c.h,
            .iterations = iterations,
            .contacts = c.contacts,
            .symbolic_cache = c.symbolic_cache,
            .undo = c.undo,
            .runaways = c.runaways,
            .manages_contacts = c.manages_contacts,
            .methods = c.methods,
            .correction = c.correction};
}

Island joined(std::span<const Island> islands)
{
    const auto all = [&](auto Island::*items) {
        const auto &first = islands.front().*items, &last = islands.back().*items;
        return std::span(first.data(), last.data() + last.size());
    };
    Island sum{all(&Island::bodies), all(&Island::joints), all(&Island::manifolds)};
    for (const Island& island : islands) {
        sum.plain_contacts += island.plain_contacts;
        sum.feedback = sum.feedback || island.feedback;
        sum.impulses = sum.impulses || island.impulses;
        sum.kept_depth = std::max(sum.kept_depth, island.kept_depth);
    }
    return sum;
}

IslandRun::IslandRun(const StepContext& step, std::span<const Island> members, IslandPlace at,
                     bool tries_again, const Tasks& all_tasks, const IslandRecords& records, Arena& memory)
    : context(step),
      world(step.world),
      place(at),
      may_try_again(tries_again),
      tasks(all_tasks),
      arena(memory),
      reports(records.reports),
      ledger(step.world, members, records.ledgers)
{
    work.island = joined(members);
    work.members = members;
    work.correction = step.correction;
}

bool IslandRun::begin(const ProblemForm& form, Real h, int substeps)
{
    if (ledger.wanted() && !ledger.begin(arena)) return false;
    if (!assemble(world, h, form, tasks, arena, work, &context.undo)) return false;
    limit_default_softness(world, h / Real(substeps), work.system);
    work.system.manifold_friction = world.manifold_friction && form.cones;
    for (std::size_t i = 0; i < reports.size(); ++i) report_errors(work, int(i), reports[i]);
    part_residuals = arena.take_zeroed<Real>(int(reports.size()));
    set_aside = arena.take<Aside>(work.system.worlds());
    if (!arena.failed()) std::fill(set_aside.begin(), set_aside.end(), Aside{});
    return !arena.failed();
}

bool IslandRun::raise_inertias(Real h, Real resolved)
{
    if (world.acts_as_ode()) return true;
    std::span<bool> marks;
    if (!reports.empty()) {
        plain_ = arena.take<SolverBody>(int(work.system.bodies.size()));
        marks = arena.take_zeroed<bool>(int(plain_.size()));
        if (arena.failed()) return false;
        std::copy(work.system.bodies.begin(), work.system.bodies.end(), plain_.begin());
    }
    raised = add_tension(work, work.system.bodies, h, resolved, arena, marks);
    std::size_t i = 0;
    for (std::size_t m = 0; m < reports.size(); ++m)
        for (std::size_t end = i + work.members[m].bodies.size(); i < end; ++i)
            reports[m].raised_bodies += marks[i];
    return !arena.failed();
}

int IslandRun::settling_iterations(int factor) const
{
    const int n = context.iterations;
    return work.island.settles() && n < kManyIterations ? n * factor : n;
}

std::uint64_t IslandRun::seed() const
{
    return world.step_count * 0x9e3779b97f4a7c15u + std::uint64_t(place.draw);
}

bool IslandRun::is_sound() const { return has_parts() || sound(work.system, 0, tasks); }

void IslandRun::report_solution()
{
    for (std::size_t i = 0; i < reports.size(); ++i) {
        if (has_parts()) solved.residual = part_residuals[i];
        epode::report_solution(work, solved, reports[i]);
    }
}

void IslandRun::report_raised() const
{
    if (raised > 0) epode::report_raised(work.system, plain_, arena, reports);
}

void IslandRun::add_solution_to_ledger(bool relaxed)
{
    if (!ledger.wanted()) return;
    for (int part = 0; part < work.system.worlds(); ++part)
        if (is_sound(part)) ledger.add_solution(work, part, relaxed);
}

void IslandRun::add_forces_to_ledger()
{
    if (!ledger.wanted()) return;
    for (int part = 0; part < work.system.worlds(); ++part)
        if (is_sound(part)) ledger.add_forces(part, context.h);
}

bool IslandRun::is_sound(int part) const { return !has_parts() || sound(work.system, part); }

bool IslandRun::is_free(int part) const
{
    const SystemPart from = work.system.begin_of(part), to = work.system.end_of(part);
    return from.blocks == to.blocks && from.joint_manifolds == to.joint_manifolds &&
           from.contact_manifolds == to.contact_manifolds;
}

std::span<Body* const> IslandRun::bodies_of(int part) const
{
    const int from = work.system.begin_of(part).bodies, to = work.system.end_of(part).bodies;
    return std::span<Body* const>(work.island.bodies).subspan(std::size_t(from), std::size_t(to - from));
}

std::span<IslandMethod> IslandRun::methods() const
{
    if (context.methods.empty()) return {};
    return context.methods.subspan(std::size_t(place.first_island), work.members.size());
}

}  // namespace epode
