// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/containment.h"

#include "dynamics/integrate.h"
#include "joints/breaking.h"
#include "step/island/divergence.h"
#include "step/island/positions/shake.h"

namespace epode {
namespace {

void stop_numbers(std::span<Body* const> bodies)
{
    for (Body* body : bodies) {
        body->spin_excess = {};
        if (!keeps_numbers(*body)) store(body->lvel, {}), store(body->avel, {});
    }
}

template <typename T>
std::span<T> slice(std::span<T> all, int from, int to)
{
    return all.subspan(std::size_t(from), std::size_t(to - from));
}

void clear_impulses_of(RowSystem& system, const SystemPart& from, const SystemPart& to)
{
    for (const RowBlock& block : slice(system.blocks, from.blocks, to.blocks))
        for (RowNumbers& n : slice(system.numbers, block.first, block.first + block.count)) n.p = 0;
    for (const JointManifold& m :
         slice(system.joint_contacts.manifolds, from.joint_manifolds, to.joint_manifolds))
        for (JointManifoldPoint& point : slice(system.joint_contacts.points, m.first, m.first + m.count))
            for (Real& p : point.p) p = 0;
    for (ContactManifold* manifold :
         slice(system.contact_manifolds, from.contact_manifolds, to.contact_manifolds))
        clear_impulses(*manifold);
}

// Velocities as before the step, and no impulses.
void take_back_part(IslandRun& run, int part)
{
    RowSystem& system = run.work.system;
    const std::span<Body* const> bodies = run.bodies_of(part);
    const SystemPart from = system.begin_of(part), to = system.end_of(part);
    stop_numbers(bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        load_velocity(*bodies[i], system.bodies[std::size_t(from.bodies) + i]);
    clear_impulses_of(system, from, to);
}

}  // namespace

bool keeps_numbers(const Body& body) { return usable(body.lvel, 3) && usable(body.avel, 3); }

void contain_part(IslandRun& run, int part)
{
    take_back_part(run, part);
    if (run.may_try_again) {
        run.set_aside[std::size_t(part)] = {true, 1};
        return;
    }
    run.context.runaways.add(*run.bodies_of(part).front());
    if (!run.reports.empty()) run.reports[std::size_t(part)].contained = true;
}

void set_part_aside(IslandRun& run, int part, Real correction)
{
    take_back_part(run, part);
    run.set_aside[std::size_t(part)] = {true, correction};
}

bool bounds_corrections(const IslandRun& run)
{
    return !run.world.acts_as_ode() && run.world.contact_max_vel < kInf;
}

Real correctable(const IslandRun& run, const IslandWork& work, Real h)
{
    if (!bounds_corrections(run) || run.context.correction == 0) return 1;
    return judge_energy(work, 0, h, true, run.tasks, run.arena).correctable;
}

bool contain_if_unsound(IslandRun& run, int part, bool may_diverge)
{
    if (!run.is_sound(part)) return contain_part(run, part), true;
    if (run.world.acts_as_ode() || run.is_free(part)) return false;
    const SolutionEnergy energy =
        judge_energy(run.work, part, run.context.h, bounds_corrections(run), run.tasks, run.arena);
    if (may_diverge && energy.diverged) return contain_part(run, part), true;
    if (energy.correctable == 1 || run.context.correction == 0) return false;
    return set_part_aside(run, part, energy.correctable), true;
}

void contain_island(IslandRun& run)
{
    const std::span<Body* const> bodies = run.work.island.bodies;
    run.context.undo.restore_poses(bodies);
    for (Joint* joint : run.work.joints) {
        joint->impulse_rows = 0;
        if (joint->driven) forget_load(*joint);
    }
    stop_numbers(bodies);
    run.context.runaways.add(*bodies.front());
    if (run.ledger.wanted()) run.ledger.forget();
    for (ManifoldEdge* edge : run.work.island.manifolds) clear_impulses(*edge->manifold);
    advance_poses(run.world, run.work, run.context.h);
    for (dIslandStepReport& report : run.reports) report.contained = true;
}

}  // namespace epode
