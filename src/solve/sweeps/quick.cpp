// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldQuickStep: a fixed number of projected SOR sweeps over
//
//   q_i = clip(p_i + W (c_i - J_i v - C_i p_i) / d_i, lo_i, hi_i),   d_i = J_i M^-1 J_i^T + C_i
//
// with friction limits that follow their parent's present impulse. Joints come first, in alternating
// directions, which carries an impulse through a chain both ways. Then come contacts, each normal before its
// tangents, in a new random order in every sweep: any fixed order tilts a stack slightly to the same side,
// and a stack at rest trembles twice as much. The numbers are a function of the step and the island. (What ODE
// does instead: solve/sweeps/shuffled.) Over-relaxation carries impulses far but leaves
// errors in the rows visited last. The second half of the sweeps therefore uses W = 1, which lets them settle (a
// third less trembling of 1,000 boxes, a fifth less error of joints in ragdolls and chains; of 800 random trees of
// light and heavy links 56 gain energy, not 92).
#include <algorithm>

#include "solve/common/contact_rows.h"
#include "solve/common/residual.h"
#include "solve/joints/joint_lanes.h"
#include "solve/solver.h"
#include "solve/sweeps/quick_contacts.h"
#include "solve/sweeps/row_sweep.h"

namespace epode {
namespace {

constexpr int kCalmShare = 2;  // the second half of the sweeps

struct Sweeps {
    ContactRows rows;  // contacts as manifolds, in whichever way they came
    QuickContacts contacts;
    JointLanes joints;
    RowSweep others;  // contacts of other kinds

    explicit Sweeps(const SweepSettings& settings) : joints(settings.iterations) {}

    bool pack(const RowSystem& system, const SweepSettings& settings, Arena& arena)
    {
        auto taken = arena.take<bool>(int(system.blocks.size()));
        if (arena.failed()) return false;
        if (!rows.gather(system, taken, arena)) return false;
        if (!joints.pack(system, arena)) return false;
        joints.load(system);
        for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = taken[i] || !system.blocks[i].contact;
        if (!others.pack(system, settings.w, taken, arena)) return false;
        const bool alone = joints.in_floats() && others.blocks().empty();
        return contacts.pack(system, rows.list(), settings, alone, arena);
    }

    void store_impulses(RowSystem& system) const
    {
        joints.store_impulses(system.numbers);
        others.store_impulses(system.numbers);
        contacts.store_impulses(rows.list().points);
        rows.store_impulses(system);
    }

    void run(std::span<Velocity> bodies, const SweepSettings& settings)
    {
        const int iterations = settings.iterations;
        const Real w = settings.w;
        CounterRandom random(settings.seed);
        const int calm = w > 1 ? iterations - iterations / kCalmShare : iterations;
        joints.apply_impulses(bodies);
        others.apply_impulses(bodies);
        contacts.begin(bodies);
        for (int i = 0; i < iterations; ++i) {
            if (i == calm) contacts.relax_by(1 / w);
            const JointSweep how{i < calm ? w : Real(1), false};
            if (const auto floats = contacts.floats(); floats.empty())
                joints.sweep(bodies, how);
            else
                joints.sweep(floats, how);
            others.sweep(bodies, i % 2 != 0);
            contacts.sweep(bodies, random);
        }
        contacts.end(bodies);
    }
};

// Moves the blocks whose bodies belong to the part to the front and returns them.
std::span<RowBlock> blocks_of(const RowSystem& system, std::size_t part)
{
    const int from = part > 0 ? system.parts[part - 1].bodies : 0, to = system.parts[part].bodies;
    const auto end =
        std::partition(system.blocks.begin(), system.blocks.end(),
                       [from, to](const RowBlock& b) { return b.body1 >= from && b.body1 < to; });
    return {system.blocks.begin(), end};
}

bool find_residuals(const RowSystem& given, const SweepSettings& settings, std::span<const SolverBody> before,
                    std::span<const ManifoldFriction> frictions, Arena& arena, SolveReport& report)
{
    RowSystem system;
    if (!expand_manifolds(given, arena, system)) return false;
    system.frictions = frictions;
    auto lo = arena.take<Real>(int(system.rows.size()));
    auto hi = arena.take<Real>(int(system.rows.size()));
    if (arena.failed()) return false;
    present_bounds(system, lo, hi);
    report.residual = natural_residual(system, before, lo, hi, arena);
    for (std::size_t part = 0; part < system.parts.size() && report.residual >= 0; ++part) {
        RowSystem one = system;
        one.blocks = blocks_of(system, part);
        one.frictions = frictions_of(system, int(part));
        settings.part_residuals[part] = natural_residual(one, before, lo, hi, arena);
    }
    return report.residual >= 0;
}

}  // namespace

bool solve_by_sweeps(RowSystem& system, const SweepSettings& settings, Arena& arena, SolveReport& report)
{
    report.method = dIslandMethodSweeps;
    report.iterations = std::max(settings.iterations, 0);
    if (system.rows.empty() && system.joint_contacts.points.empty()) return true;
    if (settings.iterations <= 0) {  // as in ODE: constraints without effect
        for (RowNumbers& n : system.numbers) n.p = 0;
        for (JointManifoldPoint& point : system.joint_contacts.points)
            for (Real& p : point.p) p = 0;
        return true;
    }
    Arena::Scope scope(arena);
    std::span<SolverBody> before;
    if (settings.want_residual) {
        before = arena.take<SolverBody>(int(system.bodies.size()));
        if (before.empty()) return false;
        std::copy(system.bodies.begin(), system.bodies.end(), before.begin());
    }
    Sweeps sweeps(settings);
    auto velocities = take_velocities(system, arena);
    if (velocities.empty() || !sweeps.pack(system, settings, arena)) return false;
    load_velocities(system, velocities);
    sweeps.run(velocities, settings);
    store_velocities(velocities, system);
    sweeps.store_impulses(system);
    if (!settings.want_residual) return true;
    const auto frictions = sweeps.contacts.manifold_frictions(arena);
    // Those of contact joints come before the others; by part they are found by their bodies.
    std::sort(frictions.begin(), frictions.end(),
              [](const ManifoldFriction& f, const ManifoldFriction& g) { return f.body1 < g.body1; });
    return find_residuals(system, settings, before, frictions, arena, report);
}

}  // namespace epode
