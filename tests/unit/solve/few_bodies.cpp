// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The dense active set of one to three bodies against principal pivoting, and how little it needs from a good
// start.
#include "solve/exact/small/few_bodies.h"

#include <gtest/gtest.h>

#include "solve/common/residual.h"
#include "systems.h"

namespace {

using namespace epode_test;

SmallResult solve(Problem& p, SolveReport& report)
{
    Arena arena;
    RowSystem system = p.system();
    FewBodies few;
    return few.solve(system, kSingle ? 1e-5 : 1e-10, arena, report);
}

Problem tumbling(std::uint64_t seed)
{
    Dice dice(seed);
    Problem p = box_grid(1, 1, 1 + int(seed % 3), Real(.5), false);
    for (SolverBody& body : p.bodies) {
        body.v += dice.vec(1);
        body.w += dice.vec(1);
    }
    return p;
}

TEST(FewBodies, agree_with_principal_pivoting)
{
    if (kSingle) GTEST_SKIP() << "compared in double";
    int settled[3] = {};  // of 100 each, with one, two and three boxes
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Problem p = tumbling(seed), other = p;
        SolveReport report, wanted;
        if (solve(p, report) == SmallResult::kNotSolved) continue;
        ++settled[seed % 3];
        EXPECT_LE(report.residual, 1e-10) << seed;
        Arena arena;
        RowSystem system = other.system();
        ASSERT_EQ(solve_by_pivoting(system, ExactSettings(), arena, wanted), SmallResult::kSolved) << seed;
        for (std::size_t i = 0; i < p.bodies.size(); ++i) {
            EXPECT_LE(length(p.bodies[i].v - other.bodies[i].v), 1e-9) << seed;
            EXPECT_LE(length(p.bodies[i].w - other.bodies[i].w), 1e-9) << seed;
        }
    }
    EXPECT_EQ(settled[0], 100) << "one box";
    EXPECT_GE(settled[1], 30) << "two";
    EXPECT_GE(settled[2], 5) << "three: most that move are left to pivoting";
}

TEST(FewBodies, a_not_solved_system_is_as_it_was)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Problem p = tumbling(seed);
        const Problem before = p;
        Arena arena;
        RowSystem system = p.system();
        SolveReport report;
        FewBodies few;
        ASSERT_EQ(few.solve(system, -1, arena, report), SmallResult::kNotSolved) << "no residual is below 0";
        for (std::size_t i = 0; i < p.bodies.size(); ++i) EXPECT_EQ(p.bodies[i].v, before.bodies[i].v);
        for (std::size_t i = 0; i < p.numbers.size(); ++i) EXPECT_EQ(p.numbers[i].p, before.numbers[i].p);
    }
}

TEST(FewBodies, one_round_a_phase_from_their_own_answer)
{
    for (int boxes = 1; boxes <= 3; ++boxes) {
        Problem p = box_grid(1, 1, boxes, Real(.5), false);
        const std::vector<SolverBody> start = p.bodies;
        SolveReport first, second;
        ASSERT_EQ(solve(p, first), SmallResult::kSolved);
        p.bodies = start;
        ASSERT_EQ(solve(p, second), SmallResult::kSolved);
        EXPECT_EQ(second.iterations, 2) << boxes;
        EXPECT_LE(second.residual, kSingle ? 1e-5 : 1e-10);
    }
}

TEST(FewBodies, redundant_rows_without_softness)
{
    for (int boxes = 1; boxes <= 2; ++boxes) {
        Problem p = box_grid(1, 1, boxes, Real(.5), false, 0);
        SolveReport report;
        ASSERT_EQ(solve(p, report), SmallResult::kSolved);
        EXPECT_LE(report.residual, kSingle ? 1e-5 : 1e-10);
        Real ground = 0, gained = Real(boxes) * p.h * Real(9.81);
        for (std::size_t i = 0; i < 12; i += 3) ground += p.numbers[i].p;
        for (const SolverBody& body : p.bodies) gained += body.v.z;
        EXPECT_NEAR(ground, gained, kSingle ? 1e-4 : 1e-10);
        EXPECT_GT(p.bodies[0].v.z, 0) << "what is too deep comes up";
    }
}

}  // namespace
