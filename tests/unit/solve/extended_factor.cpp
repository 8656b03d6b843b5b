// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Equalities in 106 bits where long lever arms and repeated joints leave eigenvalues of 1e-21 of the
// diagonal, and the arithmetic that they are solved in.
#include "solve/exact/extended/extended_factor.h"

#include <gtest/gtest.h>

#include "solve/solver.h"
#include "systems.h"

namespace {

using namespace epode_test;

// A chain whose links hold each other twice over by points that lie `far` away, in a world where nothing
// bounds rows.
Problem far_chain(std::uint64_t seed, Real far, Real cfm)
{
    Dice dice(seed);
    Problem p;
    for (int i = 0; i < 8; ++i) {
        const Vec3 place = dice.vec(3);
        p.body(place, std::pow(Real(10), dice.real(-3, 3)));
        p.bodies.back().v = dice.vec(1), p.bodies.back().w = dice.vec(1);
        for (int k = 0; k < 3; ++k) {
            const Vec3 at = place + far * dice.direction();
            p.ball(i, i - 1, at, cfm);
        }
    }
    p.pull({0, 0, Real(-9.81)});
    return p;
}

double error_of(DoubleDouble x, DoubleDouble y) { return std::fabs(rounded(x - y)); }

TEST(DoubleDouble, products_and_quotients_have_a_hundred_bits)
{
    Dice dice(1);
    for (int i = 0; i < 1000; ++i) {
        const DoubleDouble a = two_product(double(dice.real(1, 2)), double(dice.real(1, 2)));
        const DoubleDouble b = two_product(double(dice.real(1, 2)), double(dice.real(-2, -1)));
        EXPECT_LE(error_of(a * b / b, a), 1e-30);
        EXPECT_LE(error_of((a + b) * (a - b), a * a - b * b), 1e-29);
    }
    const DoubleDouble third = DoubleDouble{1, 0} / DoubleDouble{3, 0};
    EXPECT_EQ(rounded(third * 3.0 - DoubleDouble{1, 0}), 0);
    EXPECT_NE(third.lo, 0);
}

TEST(ExtendedFactor, solves_what_long_lever_arms_make_singular_in_doubles)
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Problem p = far_chain(seed, Real(1e6), Real(1e-10));
        Arena arena;
        ExactProblem problem;
        const RowSystem system = p.system();
        ASSERT_TRUE(problem.build(system, nullptr, arena));
        const std::size_t m = p.rows.size();
        std::vector<double> impulse(m, 0), low(m, 0), free(m, 1);
        for (std::size_t i = 0; i < m; i += 5) free[i] = 0;
        std::vector<DoubleDouble> sums(std::size_t(problem.unknowns())), r(m);
        ExtendedFactor factor;
        ASSERT_TRUE(factor.prepare(int(m), arena));
        factor.factor(problem, free);
        double worst = 0;
        for (int pass = 0; pass < 3; ++pass) {
            problem.defect(impulse, low, free, sums, r);
            worst = 0;
            for (const DoubleDouble& x : r) worst = std::max(worst, std::fabs(x.hi));
            factor.solve(r);
            for (std::size_t i = 0; i < m; ++i) {
                const DoubleDouble sum = DoubleDouble{impulse[i], low[i]} + r[i];
                impulse[i] = sum.hi, low[i] = sum.lo;
            }
        }
        EXPECT_LE(worst, 1e-16 * problem.scale()) << seed;
        for (std::size_t i = 0; i < m; i += 5) EXPECT_EQ(impulse[i], 0) << "a row that is not free";
    }
}

TEST(ExtendedFactor, long_lever_arms_keep_the_promise_of_the_exact_solver)
{
    if (kSingle) GTEST_SKIP() << "such arms leave no digits to floats";
    for (const Real far : {Real(1e4), Real(1e6), Real(1e8), Real(1e10)})
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Problem p = far_chain(seed, far, Real(1e-10));
            Arena arena;
            SolveReport report;
            RowSystem system = p.system();
            ASSERT_TRUE(solve_exactly(system, ExactSettings(), arena, report));
            EXPECT_LE(report.residual, 1e-9) << far << " " << seed;
        }
}

}  // namespace
