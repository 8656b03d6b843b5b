// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// QuickStep's solver against the exact one and against what must hold for any number of sweeps: bounds,
// momentum, the meaning of the parameters.
#include <gtest/gtest.h>

#include "solve/common/residual.h"
#include "solve/solver.h"
#include "systems.h"

namespace {

using namespace epode_test;

SolveReport run(Problem& p, int iterations = 20, Real w = Real(1.3), std::uint64_t seed = 1)
{
    Arena arena;
    SweepSettings settings;
    settings.iterations = iterations, settings.w = w, settings.seed = seed, settings.want_residual = true;
    SolveReport report;
    RowSystem system = p.system();
    EXPECT_TRUE(solve_by_sweeps(system, settings, arena, report));
    return report;
}

void solve_exact(Problem& p)
{
    Arena arena;
    SolveReport report;
    RowSystem system = p.system();
    EXPECT_TRUE(solve_exactly(system, {.want_residual = true}, arena, report));
}

Real difference(const Problem& a, const Problem& b)
{
    Real worst = 0;
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        worst = std::max(worst, max_component(abs(a.bodies[i].v - b.bodies[i].v)));
        worst = std::max(worst, max_component(abs(a.bodies[i].w - b.bodies[i].w)));
    }
    return worst;
}

void expect_within_bounds(const Problem& p)
{
    for (const RowNumbers& n : p.numbers) {
        const Real hi = n.parent < 0 ? n.hi : n.hi * std::fabs(p.numbers[std::size_t(n.parent)].p);
        const Real lo = n.parent < 0 ? n.lo : -hi;
        EXPECT_GE(n.p, lo - 1e-12 * std::fabs(lo));
        EXPECT_LE(n.p, hi + 1e-12 * std::fabs(hi));
    }
}

// Contacts with one row more, an empty one, are no manifolds and take the general path, row by row.
Problem in_general_form(const Problem& p)
{
    Problem out = p;
    out.rows.clear(), out.numbers.clear(), out.blocks.clear();
    for (const RowBlock& block : p.blocks) {
        const auto first = p.rows.begin() + block.first;
        std::vector<Row> of(first, first + block.count);
        if (block.contact) {
            Row empty;
            empty.kind = RowKind::kFriction, empty.lo = empty.hi = 0;
            of.push_back(empty);
        }
        const std::size_t at = out.numbers.size();
        out.block(block.body1, block.body2, block.contact, of);
        std::copy_n(p.numbers.begin() + block.first, block.count, out.numbers.begin() + long(at));
        for (int k = 0; k < block.count; ++k)
            if (int& parent = out.numbers[at + std::size_t(k)].parent; parent >= 0)
                parent += int(at) - block.first;
        out.blocks.back().arms = block.arms;
    }
    return out;
}

TEST(Quick, reaches_the_exact_answer_without_friction)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RandomKind kind;
        kind.mu = -1, kind.joints = 3, kind.heaviest = 3, kind.cfm = Real(5e-3);
        Problem exact = random_problem(seed, kind), quick = random_problem(seed, kind);
        solve_exact(exact);
        run(quick, 2000);
        EXPECT_LT(difference(exact, quick), kSingle ? 1e-2 : 1e-6) << "seed " << seed;
    }
}

TEST(Quick, packed_contacts_equal_the_same_rows_in_general_form)
{
    // With one manifold per pair of bodies and everything converged both must end in the same place.
    RandomKind kind;
    kind.joints = 0, kind.contacts = 5, kind.heaviest = 2, kind.cfm = Real(1e-3);
    Problem packed = random_problem(7, kind), general = in_general_form(packed);
    const SolveReport a = run(packed, 3000, 1), b = run(general, 3000, 1);
    EXPECT_LT(a.residual, kSingle ? 1e-4 : 1e-10);
    EXPECT_LT(b.residual, kSingle ? 1e-4 : 1e-10);
    EXPECT_LT(difference(packed, general), kSingle ? 1e-3 : 1e-8);
}

TEST(Quick, one_visit_is_the_same_on_both_paths)
{
    // One contact, one sweep, no coupling between blocks: the two paths compute the same Gauss-Seidel visit.
    for (const bool proportional : {true, false}) {
        Problem packed;
        packed.body({0, 0, 0}, 2, {1, 2, 3});
        packed.body({0, Real(.3), 2}, 1, {2, 1, 1});
        packed.bodies[0].v = {Real(.3), Real(.1), 1}, packed.bodies[1].w = {Real(.2), -1, Real(.5)};
        packed.contact(1, 0, {Real(.2), Real(.4), 1}, {0, 0, 1}, Real(.01), Real(.4), Real(1e-3),
                       proportional);
        Problem general = in_general_form(packed);
        run(packed, 1);
        run(general, 1);
        EXPECT_LT(difference(packed, general), 50 * kEpsilon);
        EXPECT_NE(packed.numbers[0].p, 0);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(packed.numbers[i].p, general.numbers[i].p, 50 * kEpsilon);
    }
}

TEST(Quick, residual_falls_with_sweeps)
{
    Real last = kInf;
    for (const int sweeps : {5, 50, 500, 5000}) {
        Problem p = pyramid(6, Real(.5), Real(1e-5));
        const SolveReport report = run(p, sweeps);
        EXPECT_EQ(report.iterations, sweeps);
        EXPECT_LT(report.residual, last);
        last = report.residual;
    }
    EXPECT_LT(last, 1e-2);
}

TEST(Quick, bounds_hold_after_any_number_of_sweeps)
{
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
        for (const int sweeps : {1, 3, 20}) {
            Problem p = random_problem(seed, {});
            for (RowNumbers& n : p.numbers) n.p = Dice(seed).real(-5, 5);  // a warm start from anywhere
            run(p, sweeps);
            expect_within_bounds(p);
        }
}

TEST(Quick, velocities_are_those_of_the_impulses)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RandomKind kind;
        kind.contacts = 20, kind.kinematic = seed % 2;
        Problem p = random_problem(seed, kind), by_hand = p;
        for (RowNumbers& n : p.numbers) n.p = Real(.1);
        run(p, 20);
        for (const RowBlock& block : p.blocks)
            for (int i = block.first; i < block.first + block.count; ++i)
                apply_impulse(p.rows[std::size_t(i)], p.numbers[std::size_t(i)].p,
                              by_hand.bodies[std::size_t(block.body1)],
                              block.body2 >= 0 ? &by_hand.bodies[std::size_t(block.body2)] : nullptr);
        EXPECT_LT(difference(p, by_hand), kSingle ? 1e-3 : 1e-11);
    }
}

TEST(Quick, momentum_of_free_bodies_is_kept)
{
    RandomKind kind;
    kind.contacts = 12;
    Problem p = random_problem(3, kind);
    for (RowBlock& block : p.blocks)
        if (block.body2 < 0) block.count = 0;  // nothing outside acts
    const auto momentum = [&](Vec3& linear, Vec3& angular) {
        linear = angular = {};
        for (std::size_t i = 0; i < p.bodies.size(); ++i) {
            const SolverBody& b = p.bodies[i];
            linear += b.mass * b.v;
            angular += cross(p.places[i], b.mass * b.v) + b.inertia * b.w;
        }
    };
    Vec3 l0, a0, l1, a1;
    momentum(l0, a0);
    const Vec3 v0 = p.bodies[0].v;
    run(p, 20);
    momentum(l1, a1);
    EXPECT_FALSE(p.bodies[0].v == v0);
    EXPECT_LT(max_component(abs(l1 - l0)), kSingle ? 1e-3 : 1e-11);
    EXPECT_LT(max_component(abs(a1 - a0)), kSingle ? 1e-3 : 1e-11);
}

TEST(Quick, no_sweeps_means_no_constraints)
{
    for (const int sweeps : {0, -5}) {
        Problem p = random_problem(5, {}), before = p;
        for (RowNumbers& n : p.numbers) n.p = 1;
        run(p, sweeps);
        EXPECT_EQ(difference(p, before), 0);
        for (const RowNumbers& n : p.numbers) EXPECT_EQ(n.p, 0);
    }
}

TEST(Quick, no_rows_is_no_work)
{
    Problem p;
    p.body({}, 1);
    EXPECT_EQ(run(p).residual, 0);
}

TEST(Quick, kinematic_bodies_keep_their_velocity)
{
    RandomKind kind;
    kind.kinematic = true, kind.contacts = 30;
    Problem p = random_problem(11, kind);
    const SolverBody before = p.bodies[0];
    run(p);
    EXPECT_TRUE(p.bodies[0].v == before.v && p.bodies[0].w == before.w);
}

TEST(Quick, infinite_friction_without_load_sticks)
{
    // ODE's QuickStep: infinity times zero bounds nothing.
    for (const bool packed : {true, false}) {
        Problem p;
        p.body({0, 0, Real(.5)}, 1);
        p.bodies[0].v = {1, 0, 1};  // sliding and leaving
        p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, kInf, Real(1e-9));
        if (!packed) p = in_general_form(p);
        run(p, 200);
        EXPECT_EQ(p.numbers[0].p, 0);
        EXPECT_LT(std::fabs(p.bodies[0].v.x + Real(.5) * -p.bodies[0].w.y), 1e-3);
    }
}

TEST(Quick, empty_rows_are_ignored)
{
    Problem p;
    p.body({0, 0, Real(.5)}, 1);
    p.contact(0, -1, {0, 0, 0}, {0, 0, 1}, 0, Real(.5), 0);
    Row empty;
    empty.kind = RowKind::kFriction, empty.lo = -1, empty.hi = 1;
    p.block(0, -1, true, {empty});
    p.numbers.back().p = 3;
    p.pull({0, 0, Real(-9.81)});
    run(p);
    EXPECT_EQ(p.numbers.back().p, 0);
    EXPECT_TRUE(std::isfinite(p.bodies[0].v.z));
}

TEST(Quick, every_safe_over_relaxation_converges)
{
    for (const Real w : {Real(.3), Real(1), Real(1.3), Real(1.7)}) {
        Problem p = chain(12, 5, Real(1e-6));
        EXPECT_LT(run(p, 1500, w).residual, kSingle ? 1e-3 : 1e-9) << w;
    }
}

TEST(Quick, same_seed_same_bits_other_seed_other_order)
{
    Problem a = pyramid(6, Real(.5)), b = pyramid(6, Real(.5)), c = pyramid(6, Real(.5));
    run(a, 20, Real(1.3), 42);
    run(b, 20, Real(1.3), 42);
    run(c, 20, Real(1.3), 43);
    EXPECT_EQ(difference(a, b), 0);
    EXPECT_GT(difference(a, c), 0);
}

// A body that touches nothing and is heavy enough has all sweeps made in Reals. These take manifolds in
// another order, which is why distances from the answer are compared.
TEST(Quick, piles_in_floats_are_as_near_the_answer_as_in_reals)
{
    for (const bool sideways : {true, false}) {
        Problem floats = box_grid(4, 4, 3, Real(.5), sideways, Real(1e-3)), reals = floats;
        reals.body({0, 0, 100}, 1e4, {1e4, 1e4, 1e4});
        Real sum = 0, sum_of_reals = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Problem a = floats, b = reals;
            sum += run(a, 50, 1, seed).residual, sum_of_reals += run(b, 50, 1, seed).residual;
        }
        EXPECT_LT(sum, Real(1.1) * sum_of_reals);
        EXPECT_NE(sum, sum_of_reals) << "both are in Reals";
    }
}

TEST(Quick, warm_start_at_the_answer_stays_there)
{
    Problem p = pyramid(5, Real(.5), Real(1e-3));
    const Problem start = p;
    run(p, 20000, 1);
    for (const int sweeps : {1, 60}) {  // in floats; so many that they are in Reals
        Problem again = start;
        for (std::size_t i = 0; i < p.numbers.size(); ++i) again.numbers[i].p = p.numbers[i].p;
        const double tolerance = sweeps == 1 ? 1e-6 : 1e-9;
        EXPECT_LT(run(again, sweeps, 1).residual, kSingle ? 1e-3 : tolerance) << sweeps;
    }
}

TEST(Quick, frictionless_and_rolling_contacts_share_an_island)
{
    Problem p = pyramid(3, -1, Real(1e-6));
    Row normal = p.point_row(0, -1, {0, 0, 0}, {0, 0, 1}, Real(.2), Real(1e-6));
    normal.kind = RowKind::kNormal, normal.lo = 0;
    std::vector<Row> of{normal};
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
        Row roll;
        roll.ang1 = axis, roll.kind = RowKind::kFriction, roll.cfm = Real(1e-6);
        roll.hi = Real(.1), roll.lo = Real(-.1), roll.parent = 0;
        of.push_back(roll);
    }
    p.block(0, -1, true, of);
    const SolveReport report = run(p, 5000);
    EXPECT_LT(report.residual, 1e-2);
    expect_within_bounds(p);
}

}  // namespace
