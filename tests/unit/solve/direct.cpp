// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The exact solver against brute force (all 3^m active sets, each solved by dense elimination in long
// double), and on what breaks pivoting methods: redundancy, CFM = 0, mass ratios.
#include <gtest/gtest.h>

#include "solve/common/residual.h"
#include "solve/solver.h"
#include "systems.h"

namespace {

using namespace epode_test;
using Wide = long double;

SolveReport run(Problem& p)
{
    Arena arena;
    ExactSettings settings;
    settings.want_residual = true;
    SolveReport report;
    RowSystem system = p.system();
    EXPECT_TRUE(solve_exactly(system, settings, arena, report));
    for (const SolverBody& b : p.bodies)
        EXPECT_TRUE(std::isfinite(length2(b.v)) && std::isfinite(length2(b.w)));
    for (const RowNumbers& n : p.numbers) EXPECT_TRUE(std::isfinite(n.p));
    return report;
}

struct Dense {
    int m;
    std::vector<Wide> A, b, lo, hi;  // A p - b = w
};

Dense dense(const Problem& p)
{
    Dense d;
    d.m = int(p.rows.size());
    d.A.assign(std::size_t(d.m * d.m), 0);
    for (const RowBlock& block : p.blocks)
        for (int j = block.first; j < block.first + block.count; ++j) {
            std::vector<SolverBody> bodies = p.bodies;
            for (SolverBody& b : bodies) b.v = b.w = {};
            apply_impulse(p.rows[std::size_t(j)], 1, bodies[std::size_t(block.body1)],
                          block.body2 >= 0 ? &bodies[std::size_t(block.body2)] : nullptr);
            for (const RowBlock& other : p.blocks)
                for (int i = other.first; i < other.first + other.count; ++i)
                    d.A[std::size_t(i * d.m + j)] =
                        row_velocity(p.rows[std::size_t(i)], bodies[std::size_t(other.body1)],
                                     other.body2 >= 0 ? &bodies[std::size_t(other.body2)] : nullptr);
        }
    for (const RowBlock& block : p.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const RowNumbers& n = p.numbers[std::size_t(i)];
            d.A[std::size_t(i * d.m + i)] += n.C;
            d.b.push_back(n.c -
                          row_velocity(p.rows[std::size_t(i)], p.bodies[std::size_t(block.body1)],
                                       block.body2 >= 0 ? &p.bodies[std::size_t(block.body2)] : nullptr));
            d.lo.push_back(n.lo), d.hi.push_back(n.hi);
        }
    return d;
}

// Solves for the free rows; false when they are dependent.
bool solve_free(const Dense& d, const std::vector<int>& state, std::vector<Wide>& p)
{
    std::vector<int> free;
    for (int i = 0; i < d.m; ++i)
        if (state[std::size_t(i)] == 1)
            free.push_back(i);
        else
            p[std::size_t(i)] = state[std::size_t(i)] == 0 ? d.lo[std::size_t(i)] : d.hi[std::size_t(i)];
    const std::size_t n = free.size();
    std::vector<Wide> M(n * (n + 1));
    for (std::size_t r = 0; r < n; ++r) {
        Wide s = d.b[std::size_t(free[r])];
        for (int j = 0; j < d.m; ++j)
            if (state[std::size_t(j)] != 1) s -= d.A[std::size_t(free[r] * d.m + j)] * p[std::size_t(j)];
        for (std::size_t c = 0; c < n; ++c) M[r * (n + 1) + c] = d.A[std::size_t(free[r] * d.m + free[c])];
        M[r * (n + 1) + n] = s;
    }
    for (std::size_t k = 0; k < n; ++k) {
        if (!(M[k * (n + 1) + k] > 1e-14L)) return false;
        for (std::size_t r = k + 1; r < n; ++r) {
            const Wide f = M[r * (n + 1) + k] / M[k * (n + 1) + k];
            for (std::size_t c = k; c <= n; ++c) M[r * (n + 1) + c] -= f * M[k * (n + 1) + c];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        Wide s = M[k * (n + 1) + n];
        for (std::size_t c = k + 1; c < n; ++c) s -= M[k * (n + 1) + c] * p[std::size_t(free[c])];
        p[std::size_t(free[k])] = s / M[k * (n + 1) + k];
    }
    return true;
}

bool brute_force(const Dense& d, std::vector<Wide>& p)
{
    int cases = 1;
    for (int i = 0; i < d.m; ++i) cases *= 3;
    for (int code = 0; code < cases; ++code) {
        std::vector<int> state;
        for (int i = 0, rest = code; i < d.m; ++i, rest /= 3) state.push_back(rest % 3);
        bool possible = true;
        for (int i = 0; i < d.m; ++i) {
            const auto k = std::size_t(i);
            possible &=
                !(state[k] == 0 && !(d.lo[k] > -HUGE_VALL)) && !(state[k] == 2 && !(d.hi[k] < HUGE_VALL));
        }
        p.assign(std::size_t(d.m), 0);
        if (!possible || !solve_free(d, state, p)) continue;
        bool right = true;
        for (int i = 0; i < d.m && right; ++i) {
            const auto k = std::size_t(i);
            Wide w = -d.b[k];
            for (int j = 0; j < d.m; ++j) w += d.A[k * std::size_t(d.m) + std::size_t(j)] * p[std::size_t(j)];
            right = state[k] == 0   ? w >= -1e-12L
                    : state[k] == 2 ? w <= 1e-12L
                                    : p[k] >= d.lo[k] - 1e-12L && p[k] <= d.hi[k] + 1e-12L;
        }
        if (right) return true;
    }
    return false;
}

TEST(Direct, agrees_with_brute_force_over_all_active_sets)
{
    if (kSingle) GTEST_SKIP() << "compared in double";
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        Dice dice(seed);
        Problem p;
        const int bodies = 1 + dice.below(3);
        for (int i = 0; i < bodies; ++i) {
            p.body(dice.vec(1), dice.real(Real(.5), 4));
            p.bodies.back().v = dice.vec(2), p.bodies.back().w = dice.vec(2);
        }
        const int m = 2 + dice.below(5);
        for (int i = 0; i < m; ++i) {
            const int a = dice.below(bodies), b = dice.below(bodies + 1) - 1;
            Row row = p.point_row(a, b == a ? -1 : b, dice.vec(1), dice.direction(), 0, Real(1e-3));
            row.speed = dice.real(-1, 1);
            const int kind = dice.below(3);
            if (kind != 0)
                row.lo = kind == 1 ? 0 : -30, row.hi = kind == 1 ? kInf : 20, row.kind = RowKind::kLimit;
            p.block(a, b == a ? -1 : b, false, {row});
        }
        const Dense d = dense(p);
        std::vector<Wide> wanted;
        ASSERT_TRUE(brute_force(d, wanted)) << seed;
        run(p);
        for (int i = 0; i < m; ++i)
            EXPECT_NEAR(p.numbers[std::size_t(i)].p, double(wanted[std::size_t(i)]), 1e-8)
                << seed << " row " << i;
    }
}

TEST(Direct, random_islands_meet_their_promise)
{
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        RandomKind kind;
        kind.joints = 4, kind.contacts = 4 + int(seed % 20), kind.kinematic = seed % 3 == 0;
        Problem p = random_problem(seed, kind);
        EXPECT_LE(run(p).residual, kSingle ? 1e-4 : 1e-9) << seed;
    }
}

TEST(Direct, without_softness)
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        RandomKind kind;
        kind.cfm = 0, kind.joints = 3, kind.contacts = 8;
        Problem p = random_problem(seed, kind);
        run(p);  // two joints of one pair may contradict each other: no answer, but numbers
        p = random_problem(seed, kind);
        for (RowNumbers& n : p.numbers) n.c = 0;  // rest satisfies everything
        EXPECT_LE(run(p).residual, kSingle ? 1e-4 : 1e-9) << seed;
    }
}

TEST(Direct, repeated_rows)
{
    for (const Real cfm : {Real(0), Real(1e-10)}) {
        Problem p;
        p.body({0, 0, Real(.5)}, 1);
        for (int i = 0; i < 8; ++i) p.contact(0, -1, {Real(.5), 0, 0}, {0, 0, 1}, 0, Real(.5), cfm);
        for (int i = 0; i < 8; ++i) p.contact(0, -1, {Real(-.5), 0, 0}, {0, 0, 1}, 0, Real(.5), cfm);
        p.pull({1, 0, Real(-9.81)});
        EXPECT_LE(run(p).residual, kSingle ? 1e-4 : 1e-9);
        EXPECT_NEAR(p.bodies[0].v.z, 0, kSingle ? 1e-4 : 1e-8);
    }
}

TEST(Direct, mass_ratio_of_a_million)
{
    for (const Real ratio : {Real(1e6), Real(1e-6)}) {
        Problem p;
        p.body({0, 0, Real(.5)}, 1);
        p.body({0, 0, Real(1.5)}, ratio);
        for (const Real x : {Real(-.5), Real(.5)})
            for (const Real y : {Real(-.5), Real(.5)}) {
                p.contact(0, -1, {x, y, 0}, {0, 0, 1}, 0, Real(.5), Real(1e-10));
                p.contact(1, 0, {x, y, 1}, {0, 0, 1}, 0, Real(.5), Real(1e-10));
            }
        p.pull({0, 0, Real(-9.81)});
        EXPECT_LE(run(p).residual, kSingle ? 1e-3 : 1e-9) << ratio;
        Real carried = 0;
        for (std::size_t i = 0; i < p.numbers.size(); i += 6) carried += p.numbers[i].p;
        EXPECT_NEAR(carried / ((1 + ratio) * p.h * Real(9.81)), 1,
                    1e-2);  // C p of the heavy one is 0.5 percent
    }
}

TEST(Direct, stacks_and_pyramids)
{
    Problem stack = box_grid(1, 1, 10, Real(.5), false, Real(1e-10)),
            wall = pyramid(10, Real(.5), Real(1e-10));
    EXPECT_LE(run(stack).residual, kSingle ? 1e-3 : 1e-9);
    EXPECT_LE(run(wall).residual, kSingle ? 1e-3 : 1e-9);
    for (const SolverBody& b : wall.bodies) EXPECT_LT(length(b.v), kSingle ? 1e-2 : 1e-6);
}

TEST(Direct, overdetermined_loop_of_joints)
{
    // A triangle of bodies, every pair welded by two coincident ball joints: 18 equations, many dependent.
    for (const Real cfm : {Real(0), Real(1e-10)}) {
        Problem p;
        for (int i = 0; i < 3; ++i) p.body({Real(i), Real(i == 1), 0}, 1);
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 2; ++k)
                p.ball(i, (i + 1) % 3,
                       Real(.5) * (p.places[std::size_t(i)] + p.places[std::size_t((i + 1) % 3)]), cfm);
        p.ball(0, -1, p.places[0], cfm);
        p.pull({0, 0, Real(-9.81)});
        EXPECT_LE(run(p).residual, kSingle ? 1e-4 : 1e-9);
        EXPECT_LT(length(p.bodies[0].v), kSingle ? 1e-4 : 1e-8);  // C p, 1e-8 s/kg times 0.3 N s
    }
}

TEST(Direct, no_rows_is_no_work)
{
    Problem p;
    p.body({}, 1);
    EXPECT_EQ(run(p).residual, 0);
}

}  // namespace
