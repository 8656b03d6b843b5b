// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Trees of joints condensed to their bounded rows, against principal pivoting on all rows; the kernels of every
// machine against each other; what is refused.
#include "solve/exact/small/condensed.h"

#include <gtest/gtest.h>

#include "systems.h"

namespace {

using namespace epode_test;

constexpr double kEnough = kSingle ? 1e-5 : 1e-10;

SmallResult solve(Problem& p, SolveReport& report,
                  const CondensedKernels& kernels = *condensed_kernels().back())
{
    Arena arena;
    RowSystem system = p.system();
    return kernels.solve(system, kEnough, arena, report);
}

// A ball joint that also holds `axes` axes, the last of them softly, as drives do. It says so if `stated`.
void joint(Problem& p, int body1, int body2, Vec3 at, int axes, Dice& dice, bool stated)
{
    std::vector<Row> of;
    for (const Vec3& d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        of.push_back(p.point_row(body1, body2, at, d, Real(0.2), Real(1e-8)));
        of.back().error = dice.real(Real(-.01), Real(.01));
    }
    for (int i = 0; i < axes; ++i) {
        Row row;
        row.ang1 = dice.direction(), row.ang2 = -row.ang1;
        row.speed = dice.real(-1, 1);
        row.cfm = i == axes - 1 ? Real(0.02) : Real(1e-9);
        of.push_back(row);
    }
    p.block(body1, body2, false, of);
    const auto arm = [&](int body) { return at - p.places[std::size_t(body)]; };
    p.blocks.back().point = stated;
    p.blocks.back().arms = {arm(body1), arm(body2)};
}

// A tree of links on ball joints, some of them hinges, with `contacts` on links that the dice choose; on a
// kinematic body or free. Every other body is `ratio` times as heavy.
Problem tree(std::uint64_t seed, int links, int contacts, Real ratio = 3, bool stated = true)
{
    Dice dice(seed);
    Problem p;
    for (int i = 0; i < links; ++i) {
        const bool held = i == 0 && seed % 3 == 0;
        const Real mass = held ? 0 : i % 2 ? ratio : Real(1);
        const Vec3 sides{dice.real(Real(.3), 1), dice.real(Real(.3), 1), dice.real(Real(.3), 1)};
        const int body = p.body(dice.vec(2), mass, sides);
        p.bodies[std::size_t(body)].v = dice.vec(1);
        p.bodies[std::size_t(body)].w = dice.vec(1);
        if (i == 0) continue;
        const int parent = dice.below(i);
        joint(p, i % 3 ? body : parent, i % 3 ? parent : body, dice.vec(2), i % 4, dice, stated);
    }
    for (int k = 0; k < contacts; ++k) {
        const int body = 1 + dice.below(links - 1);
        const Vec3 at = p.places[std::size_t(body)] + dice.vec(Real(.5));
        const Real depth = dice.real(0, Real(.02));  // arguments have no order
        p.contact(body, -1, at, dice.direction(), depth, Real(.6), Real(1e-8));
    }
    return p;
}

void expect_same_velocities(const Problem& p, const Problem& other, std::uint64_t seed)
{
    for (std::size_t i = 0; i < p.bodies.size(); ++i) {
        EXPECT_LE(length(p.bodies[i].v - other.bodies[i].v), 1e-8) << seed;
        EXPECT_LE(length(p.bodies[i].w - other.bodies[i].w), 1e-8) << seed;
    }
}

TEST(Condensed, agrees_with_pivoting_on_all_rows)
{
    if (kSingle) GTEST_SKIP() << "compared in double";
    int solved = 0, compared = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Problem p = tree(seed, 2 + int(seed % 7), 1 + int(seed % 5)), other = p;
        SolveReport report, wanted;
        if (solve(p, report) != SmallResult::kSolved) continue;
        ++solved;
        EXPECT_LE(report.residual, 1e-10) << seed;
        EXPECT_EQ(report.factorisations, 1) << seed;
        Arena arena;
        RowSystem system = other.system();
        if (solve_by_pivoting(system, ExactSettings(), arena, wanted) != SmallResult::kSolved) continue;
        ++compared;
        expect_same_velocities(p, other, seed);
    }
    EXPECT_GE(solved, 294) << "few lack digits, which the other methods have";
    EXPECT_GE(compared, 280);
}

TEST(Condensed, point_joints_are_what_their_rows_are)
{
    if (kSingle) GTEST_SKIP() << "compared in double";
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const int links = 2 + int(seed % 9), contacts = 1 + int(seed % 4);
        Problem p = tree(seed, links, contacts), rows = tree(seed, links, contacts, 3, false);
        SolveReport report, wanted;
        if (solve(p, report) != SmallResult::kSolved || solve(rows, wanted) != SmallResult::kSolved) continue;
        ++solved;
        EXPECT_LE(report.residual, 1e-10) << seed;
        expect_same_velocities(p, rows, seed);
        for (std::size_t i = 0; i < p.numbers.size(); ++i)
            EXPECT_NEAR(p.numbers[i].p, rows.numbers[i].p, 1e-7 * (1 + std::fabs(p.numbers[i].p))) << seed;
    }
    EXPECT_GE(solved, 190) << "some lack digits, which the other methods have";
}

TEST(Condensed, mass_ratios_of_a_thousand)
{
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Problem p = tree(seed, 6, 2, Real(1e3));
        SolveReport report;
        if (solve(p, report) != SmallResult::kSolved) continue;
        ++solved;
        EXPECT_LE(report.residual, kEnough) << seed;
    }
    EXPECT_GE(solved, 95);
}

TEST(Condensed, every_machine_has_the_same_bits)
{
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const Problem start = tree(seed, 8, 3);
        Problem first = start;
        SolveReport report;
        const SmallResult wanted = solve(first, report, *condensed_kernels().front());
        for (const CondensedKernels* kernels : condensed_kernels()) {
            Problem p = start;
            ASSERT_EQ(solve(p, report, *kernels), wanted);
            for (std::size_t i = 0; i < p.bodies.size(); ++i) {
                EXPECT_EQ(p.bodies[i].v, first.bodies[i].v) << kernels->name << ' ' << seed;
                EXPECT_EQ(p.bodies[i].w, first.bodies[i].w) << kernels->name << ' ' << seed;
            }
            for (std::size_t i = 0; i < p.numbers.size(); ++i)
                EXPECT_EQ(p.numbers[i].p, first.numbers[i].p) << kernels->name << ' ' << seed;
        }
    }
}

// Not of this kind: the system is as it was.
void expect_refused(Problem p)
{
    const Problem before = p;
    SolveReport report;
    EXPECT_EQ(solve(p, report), SmallResult::kNotSolved);
    for (std::size_t i = 0; i < p.bodies.size(); ++i) EXPECT_EQ(p.bodies[i].v, before.bodies[i].v);
    for (std::size_t i = 0; i < p.numbers.size(); ++i) EXPECT_EQ(p.numbers[i].p, before.numbers[i].p);
}

TEST(Condensed, loops_are_refused)
{
    Problem ring = tree(1, 3, 1);
    ring.ball(0, 2, {0, 0, 1}, Real(1e-8));
    ring.ball(1, 2, {0, 0, 2}, Real(1e-8));
    ring.ball(0, 1, {0, 0, 3}, Real(1e-8));
    expect_refused(ring);
    Problem held = tree(1, 3, 1);
    held.ball(0, -1, {0, 0, 1}, Real(1e-8));
    held.ball(2, -1, {0, 0, 2}, Real(1e-8));
    expect_refused(held);
}

TEST(Condensed, ball_joints_alone_are_left_to_the_faster_methods)
{
    Problem p;
    for (int i = 0; i < 4; ++i) {
        p.body({Real(i), 0, 0}, 1);
        if (i > 0) p.ball(i, i - 1, {i - Real(.5), 0, 0}, Real(1e-8));
    }
    expect_refused(p);
}

TEST(Condensed, bodies_without_joints_are_refused)
{
    Problem p;
    p.body({0, 0, 0}, 1);
    p.contact(0, -1, {0, 0, Real(-.5)}, {0, 0, 1}, 0, 1, 0);
    expect_refused(p);
}

TEST(Condensed, a_missed_precision_changes_nothing)
{
    Problem p = tree(5, 6, 3);
    const Problem before = p;
    Arena arena;
    RowSystem system = p.system();
    SolveReport report;
    ASSERT_EQ(condensed_kernels().back()->solve(system, -1, arena, report), SmallResult::kNotSolved);
    for (std::size_t i = 0; i < p.bodies.size(); ++i) EXPECT_EQ(p.bodies[i].v, before.bodies[i].v);
    for (std::size_t i = 0; i < p.numbers.size(); ++i) EXPECT_EQ(p.numbers[i].p, before.numbers[i].p);
}

// A ball joint and an angular motor's drive between the same bodies are one joint of six rows.
TEST(Condensed, joints_of_the_same_bodies_are_one)
{
    Problem p;
    p.body({0, 0, 0}, 1), p.body({1, 0, 0}, 2);
    p.ball(0, 1, {Real(.5), 0, 0}, Real(1e-8));
    std::vector<Row> drive(3);
    for (int k = 0; k < 3; ++k) {
        Vec3 axis;
        (k == 0 ? axis.x : k == 1 ? axis.y : axis.z) = 1;
        drive[std::size_t(k)].ang1 = -axis, drive[std::size_t(k)].ang2 = axis;
        drive[std::size_t(k)].speed = Real(k), drive[std::size_t(k)].cfm = Real(1e-8);
    }
    p.block(1, 0, false, drive);
    p.contact(1, -1, {1, 0, Real(-.5)}, {0, 0, 1}, 0, 1, Real(1e-8));
    SolveReport report;
    ASSERT_EQ(solve(p, report), SmallResult::kSolved);
    const Vec3 turn = p.bodies[0].w - p.bodies[1].w;
    for (const Real miss : {turn.x, turn.y - 1, turn.z - 2}) EXPECT_NEAR(miss, 0, 1e-4);
}

}  // namespace
