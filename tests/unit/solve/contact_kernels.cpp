// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The kernels of every machine must leave the same bits: whoever steps a world on another processor gets the
// same world. Each is run by name here, whatever the library would choose.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "solve/contact_rows.h"
#include "solve/contact_set.h"
#include "systems.h"

namespace {

using namespace epode_test;

struct Outcome {
    std::vector<Velocity> velocities;
    std::vector<RowNumbers> numbers;
    std::vector<Lanes> approach;  // J_n v of every point
};

Outcome outcome_of(const ContactKernels& kernels, Problem problem, int sweeps)
{
    Arena arena;
    const RowSystem system = problem.system();
    ContactSet set(kernels);
    const auto packed = arena.take<bool>(int(system.blocks.size()));
    ContactRows rows;
    EXPECT_TRUE(rows.gather(system, packed, arena));
    EXPECT_TRUE(set.pack(system, rows.list(), Real(1.3), arena));
    for (const bool p : packed) EXPECT_TRUE(p);
    Outcome out;
    out.velocities.resize(system.bodies.size() + 1);
    load_velocities(system, out.velocities);
    CounterRandom random(3);
    set.apply_impulses(out.velocities);
    for (int i = 0; i < sweeps; ++i) {
        set.shuffle(random);
        set.sweep(out.velocities);
    }
    set.store_impulses(rows.list().points);
    rows.for_each_impulse([&](int row, Real p) { problem.numbers[std::size_t(row)].p = p; });
    out.numbers = problem.numbers;
    for (const ContactBatch& batch : set.batches()) {
        Lanes v[kManifoldPoints];
        set.normal_velocities(batch, out.velocities, v);
        out.approach.insert(out.approach.end(), v, v + batch.count);
    }
    return out;
}

// The impulses that float sweeps find, and the velocities that they leave.
struct FloatOutcome {
    std::vector<Velocity> velocities;
    std::vector<ManifoldPoint> points;
};

FloatOutcome outcome_in_floats(const ContactKernels& kernels, Problem problem, int sweeps)
{
    Arena arena;
    const RowSystem system = problem.system();
    FloatContactSet set(kernels);
    const auto packed = arena.take<bool>(int(system.blocks.size()));
    ContactRows rows;
    EXPECT_TRUE(rows.gather(system, packed, arena));
    EXPECT_TRUE(set.pack(system, rows.list(), Real(1.3), arena));
    FloatOutcome out;
    out.velocities.resize(system.bodies.size() + 1);
    load_velocities(system, out.velocities);
    const int slots = int(out.velocities.size());
    std::vector<FloatVelocity> floats(out.velocities.size());
    CounterRandom random(3);
    kernels.round_velocities(out.velocities.data(), slots, floats.data());
    set.apply_impulses(floats);
    for (int i = 0; i < sweeps; ++i) {
        set.shuffle(random);
        set.sweep(floats);
    }
    kernels.add_changes(floats.data(), slots, out.velocities.data());
    set.store_impulses(rows.list().points);
    out.points.assign(rows.list().points.begin(), rows.list().points.end());
    return out;
}

Problem warm_problem(std::uint64_t seed)
{
    RandomKind kind;
    kind.bodies = 40, kind.joints = 0, kind.contacts = 90, kind.heaviest = 5, kind.kinematic = true;
    Problem p = random_problem(seed, kind);
    Dice dice(seed + 1000);
    for (RowNumbers& n : p.numbers) n.p = dice.real(-1, 1);  // some beyond their limits
    return p;
}

template <typename T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(std::memcmp(&a[i], &b[i], sizeof(T)), 0) << "at " << i;
}

std::vector<Problem> all_problems()
{
    std::vector<Problem> problems{box_grid(3, 3, 4, Real(0.5), true), box_grid(3, 2, 2, -1, false),
                                  pyramid(6, Real(0.4))};
    for (std::uint64_t seed = 1; seed <= 5; ++seed) problems.push_back(warm_problem(seed));
    return problems;
}

TEST(ContactKernels, AllMachinesMakeTheSameBits)
{
    const auto all = contact_kernels();
    ASSERT_STREQ(all[0]->name, "baseline");
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    for (const Problem& problem : all_problems()) {
        const Outcome expected = outcome_of(*all[0], problem, 12);
        for (const ContactKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            const Outcome got = outcome_of(*other, problem, 12);
            expect_same_bits(expected.velocities, got.velocities);
            expect_same_bits(expected.approach, got.approach);
            ASSERT_EQ(expected.numbers.size(), got.numbers.size());
            for (std::size_t i = 0; i < got.numbers.size(); ++i)
                EXPECT_EQ(std::memcmp(&expected.numbers[i].p, &got.numbers[i].p, sizeof(Real)), 0) << i;
        }
    }
}

TEST(ContactKernels, AllMachinesMakeTheSameBitsInFloats)
{
    const auto all = contact_kernels();
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    for (const Problem& problem : all_problems()) {
        const FloatOutcome expected = outcome_in_floats(*all[0], problem, 12);
        for (const ContactKernels* other : all.subspan(1)) {
            SCOPED_TRACE(other->name);
            const FloatOutcome got = outcome_in_floats(*other, problem, 12);
            expect_same_bits(expected.velocities, got.velocities);
            expect_same_bits(expected.points, got.points);
        }
    }
}

TEST(ContactKernels, ApproachIsThatOfTheNormalRows)
{
    const Problem problem = warm_problem(9);
    for (const ContactKernels* kernels : contact_kernels()) {
        SCOPED_TRACE(kernels->name);
        Arena arena;
        Problem p = problem;
        const RowSystem system = p.system();
        ContactSet set(*kernels);
        auto packed = arena.take<bool>(int(system.blocks.size()));
        ContactRows rows;
        ASSERT_TRUE(rows.gather(system, packed, arena) && set.pack(system, rows.list(), 1, arena));
        std::vector<Velocity> velocities(system.bodies.size() + 1);
        load_velocities(system, velocities);
        int compared = 0;
        for (const ContactBatch& batch : set.batches()) {
            Lanes v[kManifoldPoints];
            set.normal_velocities(batch, velocities, v);
            for (int i = 0; i < batch.count; ++i)
                for (int lane = 0; lane < kLanes; ++lane) {
                    const int point = set.sources()[std::size_t(batch.first + i)].point[lane];
                    if (point < 0) continue;
                    const int row = rows.row_of(point);
                    const SolverBody* b2 = std::size_t(batch.body2[lane]) < system.bodies.size()
                                               ? &system.bodies[std::size_t(batch.body2[lane])]
                                               : nullptr;
                    const Real expected = row_velocity(system.rows[std::size_t(row)],
                                                       system.bodies[std::size_t(batch.body1[lane])], b2);
                    EXPECT_NEAR(v[i][lane], expected, kSingle ? 1e-4 : 1e-12);
                    ++compared;
                }
        }
        EXPECT_EQ(compared, int(system.blocks.size()));
    }
}

}  // namespace
