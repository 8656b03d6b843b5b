// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packed rows against the same rows one by one, and the kernels of every machine against each other: all must
// leave the same bits through an active set and an interior point.
#include "solve/exact/problem/packed_rows.h"

#include <gtest/gtest.h>

#include <cstring>
#include <new>
#include <vector>

#include "solve/exact/active_set.h"
#include "solve/exact/interior_point.h"
#include "systems.h"

namespace {

using namespace epode_test;

// A box problem with its limits resolved: friction rows get constant ones, every fifth row is fixed.
struct BoxCase {
    Problem problem;
    Arena arena;
    ExactProblem exact;
    std::vector<double> lo, hi, p, v;
    std::vector<BoxState::Tag> tag;
    BoxState state;

    explicit BoxCase(std::uint64_t seed)
    {
        RandomKind kind;
        kind.bodies = 30, kind.joints = 12, kind.contacts = 60, kind.heaviest = 5, kind.kinematic = true;
        problem = random_problem(seed, kind);
        const RowSystem system = problem.system();
        EXPECT_TRUE(exact.build(system, nullptr, arena) &&
                    exact.build_factor(system, nullptr, Tasks(1), arena));
        Dice dice(seed + 50);
        for (std::size_t i = 0; i < problem.rows.size(); ++i) {
            const RowNumbers& n = problem.numbers[i];
            lo.push_back(n.parent >= 0 ? -0.3 : double(n.lo));
            hi.push_back(n.parent >= 0 ? 0.3 : double(n.hi));
            p.push_back(std::min(std::max(double(dice.real(-1, 1)), lo.back()), hi.back()));
            if (i % 5 == 4) lo.back() = hi.back() = p.back();
            tag.push_back(i % 5 == 4 ? BoxState::kFixed : BoxState::kFree);
        }
        v.resize(std::size_t(exact.unknowns()));
        state.lo = lo, state.hi = hi, state.p = p, state.v = v, state.tag = tag;
    }
};

TEST(PackedRows, are_the_rows_one_by_one)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        for (const RowKernels* kernels : row_kernels()) {
            SCOPED_TRACE(kernels->name);
            BoxCase box(seed);
            PackedRows packed(*kernels);
            ASSERT_TRUE(packed.prepare(box.exact, box.arena));
            packed.pack(box.exact, box.state);
            Dice dice(seed + 7);
            std::vector<double> v(box.v.size()), x(box.v.size()), expected(box.v.size());
            for (double& each : v) each = double(dice.real(-1, 1));
            std::vector<double> jv(std::size_t(packed.count())), s(jv.size());
            packed.products(v, jv);
            int seen = 0;
            for (int i = 0; i < packed.count(); ++i) {
                const int row = packed.row(i);
                s[std::size_t(i)] = double(dice.real(-1, 1));
                if (row < 0) continue;
                ++seen;
                EXPECT_NE(box.tag[std::size_t(row)], BoxState::kFixed);
                const ExactRow& exact = box.exact.row(row);
                EXPECT_NEAR(jv[std::size_t(i)], ExactProblem::jv(exact, v.data()), 1e-13);
                ExactProblem::add_jt(exact, s[std::size_t(i)], expected.data());
            }
            EXPECT_EQ(seen, int(box.p.size() - box.p.size() / 5));
            packed.add_transposed(s, x);
            for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-12);

            // Velocities count the fixed rows' impulses too.
            std::vector<double> momentum(v.size()), from_all(v.size());
            packed.velocities(box.exact, momentum, v);
            box.exact.velocities(box.p, from_all);
            for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(v[i], from_all[i], 1e-12);
        }
}

struct Outcome {
    std::vector<double> p, v;
    int iterations = 0;
    bool interior = false, exact = false;
};

Outcome solve_with(const RowKernels& kernels, std::uint64_t seed)
{
    BoxCase box(seed);
    PackedRows packed(kernels);
    InteriorPoint interior;
    ActiveSet active;
    EXPECT_TRUE(packed.prepare(box.exact, box.arena));
    EXPECT_TRUE(interior.prepare(box.exact, packed.max_places(), box.arena));
    EXPECT_TRUE(active.prepare(box.exact, packed.max_places(), box.arena));
    packed.pack(box.exact, box.state);
    Outcome out;
    out.interior = interior.solve(box.exact, packed, box.v, 2e-10, out.iterations);
    out.exact = active.solve(box.exact, packed, box.v, {100, true}, out.iterations);
    packed.unpack(box.state);
    EXPECT_LT(box.exact.residual(box.state, box.v), 1e-12);
    out.p = box.p, out.v = box.v;
    return out;
}

// What lay on the stack before is no part of the problem: it once decided whether the method gave up.
TEST(InteriorPoint, begins_the_same_in_any_memory)
{
    alignas(InteriorPoint) unsigned char memory[sizeof(InteriorPoint)];
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::vector<double> p[2];
        for (const int byte : {0, 0xff}) {
            BoxCase box(seed);
            PackedRows packed(*row_kernels().front());
            std::memset(memory, byte, sizeof memory);
            asm volatile("" : : "r"(memory) : "memory");  // or nobody would write what nobody may read
            auto* interior = new (memory) InteriorPoint;
            ASSERT_TRUE(packed.prepare(box.exact, box.arena));
            ASSERT_TRUE(interior->prepare(box.exact, packed.max_places(), box.arena));
            packed.pack(box.exact, box.state);
            int iterations = 0;
            interior->solve(box.exact, packed, box.v, 0, iterations);  // until it stalls
            interior->~InteriorPoint();
            packed.unpack(box.state);
            p[byte != 0] = box.p;
            p[byte != 0].push_back(iterations);
        }
        EXPECT_EQ(p[0], p[1]) << seed;
    }
}

TEST(RowKernels, all_machines_make_the_same_bits)
{
    ASSERT_STREQ(row_kernels().front()->name, "baseline");
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const Outcome expected = solve_with(*row_kernels().front(), seed);
        EXPECT_TRUE(expected.interior && expected.exact);
        for (const RowKernels* kernels : row_kernels().subspan(1)) {
            SCOPED_TRACE(kernels->name);
            const Outcome got = solve_with(*kernels, seed);
            EXPECT_EQ(expected.iterations, got.iterations);
            EXPECT_EQ(std::memcmp(expected.p.data(), got.p.data(), 8 * got.p.size()), 0);
            EXPECT_EQ(std::memcmp(expected.v.data(), got.v.data(), 8 * got.v.size()), 0);
        }
    }
}

}  // namespace
