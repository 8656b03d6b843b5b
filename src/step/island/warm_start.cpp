// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/warm_start.h"

#include <algorithm>
#include <cmath>

#include "step/island/fitting_start.h"
#include "step/island/problem/joint_memory.h"
#include "step/island/problem/manifold_rows.h"

namespace epode {
namespace {

// Tickets in the contact cache: points of manifolds first, then contacts that are rows.
int ticket_of_point(const IslandRun& run, int point) { return run.place.first_contact + point; }

int ticket_of_block(const IslandRun& run, std::size_t block)
{
    return run.place.first_contact + int(run.work.contacts.size() + block);
}

std::span<JointManifoldPoint> points_of(const IslandRun& run, const JointManifold& m)
{
    return run.work.system.joint_contacts.points.subspan(std::size_t(m.first), std::size_t(m.count));
}

// Directions and bodies of a contact that is rows: the first row has the normal; the linear parts of the
// others are tangents or zero.
JointManifold directions_of(const RowSystem& system, const RowBlock& block)
{
    const Row* rows = &system.rows[std::size_t(block.first)];
    JointManifold m{};
    m.n = rows[0].lin1;
    if (block.count > 1) m.t1 = rows[1].lin1;
    if (block.count > 2) m.t2 = rows[2].lin1;
    m.body1 = block.body1, m.body2 = block.body2;
    return m;
}

void load_contact(const IslandRun& run, int ticket, const JointManifold& m,
                  std::span<JointManifoldPoint> points, Real share)
{
    if (run.context.diverged > 0) return;  // they are noted
    const auto& bodies = run.work.island.bodies;
    const Body* body2 = m.body2 >= 0 ? bodies[std::size_t(m.body2)] : nullptr;
    run.context.contacts.load(run.place.index, ticket, *bodies[std::size_t(m.body1)], body2, m, points, share,
                              run.work.system.h);
}

void load_contact_rows(const IslandRun& run, std::size_t k, Real share)
{
    const RowSystem& system = run.work.system;
    const RowBlock& block = system.blocks[k];
    JointManifoldPoint point{block.arms.r1, 0, 0, 0, {}};
    load_contact(run, ticket_of_block(run, k), directions_of(system, block), {&point, 1}, share);
    for (int i = 0; i < std::min(block.count, 3); ++i)
        system.numbers[std::size_t(block.first + i)].p = point.p[i];
}

void remember_contact_rows(const IslandRun& run, std::size_t k, Real times)
{
    const RowSystem& system = run.work.system;
    const RowBlock& block = system.blocks[k];
    JointManifoldPoint point{};
    for (int i = 0; i < std::min(block.count, 3); ++i)
        point.p[i] = system.numbers[std::size_t(block.first + i)].p;
    run.context.contacts.remember(ticket_of_block(run, k), directions_of(system, block), {&point, 1}, times);
}

void remember_contacts(const IslandRun& run, Real times, const Blows& blows)
{
    if (run.context.diverged > 0) return;
    const RowSystem& system = run.work.system;
    for (const JointManifold& m : system.joint_contacts.manifolds)
        if (!blows.struck(system, m))
            run.context.contacts.remember(ticket_of_point(run, m.first), m, points_of(run, m), times);
    for (std::size_t k = 0; k < run.work.joints.size(); ++k)
        if (system.blocks[k].contact && !blows.struck(system, k)) remember_contact_rows(run, k, times);
}

constexpr Real kTurn = Real(0.15);  // rad in a step
constexpr Real kJerk = 1;           // m/s of a body by an impulse

// Does an impulse of a joint jerk a body, as it would if nothing balanced it?
bool jerks(const RowSystem& system, const RowBlock& block)
{
    if (block.contact || block.term_count > 0) return false;
    const auto of_mass = [&](int body) {
        return body < 0 ? Real(0) : system.bodies[std::size_t(body)].inv_mass;
    };
    const Real inv_mass = std::max(of_mass(block.body1), of_mass(block.body2));
    const auto numbers = system.numbers.subspan(std::size_t(block.first), std::size_t(block.count));
    return std::any_of(numbers.begin(), numbers.end(),
                       [&](const RowNumbers& n) { return std::fabs(n.p) * inv_mass > kJerk; });
}

// The last step ended with D <= 0 (fitting_start.h). The same impulses may begin with more where arms have turned, the step has another size,
// or impulses hold each other that are large for what they act on.
bool may_not_fit(const IslandRun& run)
{
    const RowSystem& system = run.work.system;
    const auto turns = [h = system.h](const Body* body) {
        return length2(body->angular_velocity()) * (h * h) > kTurn * kTurn;
    };
    const auto was_other = [h = system.h](const Joint* joint) {
        return !is_contact(*joint) && step_ratio(lasting(*joint), h) != 1;
    };
    const auto jerked = [&](const RowBlock& block) { return jerks(system, block); };
    const Island& island = run.work.island;
    return std::any_of(island.bodies.begin(), island.bodies.end(), turns) ||
           std::any_of(run.work.joints.begin(), run.work.joints.end(), was_other) ||
           std::any_of(system.blocks.begin(), system.blocks.end(), jerked);
}

}  // namespace

void load_warm_start(IslandRun& run, const WarmStart& how)
{
    const RowSystem& system = run.work.system;
    const Real wanted = run.world.warm_starting, share = wanted * how.share;
    if (how.has_manifold_rows) load_manifold_impulses(run.work, share / Real(how.solutions));
    for (const JointManifold& m : system.joint_contacts.manifolds)
        load_contact(run, ticket_of_point(run, m.first), m, points_of(run, m), share);
    for (std::size_t k = 0; k < run.work.joints.size(); ++k) {
        if (system.blocks[k].contact)
            load_contact_rows(run, k, share);
        else
            load_memory(lasting(*run.work.joints[k]), system.blocks[k], system, wanted, how.share,
                        how.substeps);
    }
}

void load_fitting_start(IslandRun& run, const WarmStart& how)
{
    load_warm_start(run, how);
    if (has_lasting_joints(run.work.island) && !run.world.acts_as_ode() && may_not_fit(run))
        fit_start(run.work.system, run.work.island.bodies, how.substeps, run.arena);
}

void keep_impulses(IslandRun& run, const WarmStart& how, const Blows& blows)
{
    const RowSystem& system = run.work.system;
    remember_contacts(run, Real(how.solutions), blows);
    for (std::size_t k = 0; k < run.work.joints.size(); ++k)
        if (!system.blocks[k].contact)
            note_mean_force(lasting(*run.work.joints[k]), system.blocks[k], system, run.context.h);
    if (how.has_manifold_rows) store_manifold_impulses(run.work, Real(how.solutions));
}

}  // namespace epode
