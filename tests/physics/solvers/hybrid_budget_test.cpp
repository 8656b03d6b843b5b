// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The budget of hybrid steps: what is solved exactly when there is more of it than a step has time for. Nothing
// here is timed: the work of a step is its factorisations.
#include "scenes.h"

namespace epode::physics {
namespace {

constexpr double kH = 1.0 / 60;
constexpr int kBoxes = 10;

bool is_exact(int method)
{
    return method == dIslandMethodDense || method == dIslandMethodActiveSet ||
           method == dIslandMethodInteriorPoint;
}

// What a step has done.
struct Work {
    int islands = 0, exact = 0, factorisations = 0;
};

// Stacks of ten crates of 20 kg, which would topple in substeps, in the game preset.
class Stacks : public Sim {
  public:
    explicit Stacks(int count, double budget = 1, int threads = 1)
    {
        dWorldUseDefaults(world, dDefaultsGame);
        dWorldSetStepThreads(world, threads);
        dWorldSetHybridBudget(world, real(budget));
        dWorldSetContactSpace(world, space);
        dWorldSetStepReportMode(world, 1);
        gravity(0, 0, -9.81);
        ground();
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < kBoxes; ++k)
                box({i % 10 * 0.55, i / 10 * 0.55, 0.25 + k * 0.5}, {0.5, 0.5, 0.5}, 20);
    }

    Work step()
    {
        EXPECT_EQ(dWorldStepHybrid(world, real(kH)), 1);
        Work work;
        dIslandStepReport island{};
        island.struct_size = sizeof island;
        for (work.islands = 0; work.islands < report().islands; ++work.islands) {
            EXPECT_EQ(dWorldGetIslandStepReport(world, work.islands, &island), 1);
            work.exact += is_exact(island.method), work.factorisations += island.factorisations;
        }
        return work;
    }
    // The largest of any step.
    Work steps(int count)
    {
        Work largest;
        for (int i = 0; i < count; ++i) {
            const Work now = step();
            largest.islands = std::max(largest.islands, now.islands),
            largest.exact = std::max(largest.exact, now.exact);
            largest.factorisations = std::max(largest.factorisations, now.factorisations);
        }
        return largest;
    }
};

TEST(HybridBudget, one_stack_is_solved_exactly)
{
    Stacks alone(1);
    alone.steps(10);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(alone.step().exact, 1) << i;
}

// The hundred take 1.5 ms in substeps, and 10 to 20 microseconds for one factorisation of one.
TEST(HybridBudget, is_shared_by_a_hundred_stacks)
{
    const Work within = Stacks(100).steps(60), without = Stacks(100, real(dInfinity)).steps(60);
    EXPECT_GE(within.islands, 100);
    EXPECT_GE(without.exact, 100);
    EXPECT_GT(within.exact, 0);
    EXPECT_LT(within.factorisations, 200);
    EXPECT_LT(within.factorisations, 0.4 * without.factorisations);
}

TEST(HybridBudget, is_what_the_program_sets)
{
    EXPECT_EQ(Stacks(20, 0).steps(20).factorisations, 0);
    const int one = Stacks(100, 1).steps(20).factorisations, four = Stacks(100, 4).steps(20).factorisations;
    EXPECT_GT(four, 2 * one);
}

TEST(HybridBudget, does_not_hold_for_requests)
{
    Stacks stacks(20, 0);
    dBodySetHybridStepper(stacks.bodies[0], dStepperExact);
    stacks.steps(10);
    EXPECT_EQ(stacks.step().exact, 1);
}

TEST(HybridBudget, stands_what_it_leaves_to_substeps)
{
    Stacks stacks(100);
    stacks.steps(300);
    for (std::size_t i = kBoxes - 1; i < stacks.bodies.size(); i += kBoxes)
        EXPECT_NEAR(position(stacks.bodies[i]).z, 0.25 + 0.5 * (kBoxes - 1), 0.03) << i;
}

TEST(HybridBudget, gives_the_same_bits_on_any_number_of_threads)
{
    const auto hash = [](int threads) {
        Stacks stacks(100, 1, threads);
        stacks.steps(40);
        return hash_state(stacks);
    };
    const std::uint64_t alone = hash(1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), alone) << threads;
}

// What bodies remember of it is part of the state.
TEST(HybridBudget, is_remembered_by_states)
{
    Stacks stacks(100);
    stacks.steps(7);
    std::vector<std::byte> state(std::size_t(dWorldGetStateSize(stacks.world)));
    ASSERT_GT(dWorldGetState(stacks.world, state.data(), state.size()), 0u);
    stacks.steps(30);
    const std::uint64_t first = hash_state(stacks);
    ASSERT_EQ(dWorldSetState(stacks.world, state.data(), state.size()), 1);
    stacks.steps(30);
    EXPECT_EQ(hash_state(stacks), first);
}

TEST(HybridBudget, refuses_what_is_none)
{
    Stacks stacks(1, 3);
    const Messages messages;
    dWorldSetHybridBudget(stacks.world, -1);
    dWorldSetHybridBudget(stacks.world, real(NAN));
    EXPECT_EQ(messages.count(), 2);
    EXPECT_EQ(dWorldGetHybridBudget(stacks.world), 3);
    dWorldSetHybridBudget(stacks.world, dInfinity);
    EXPECT_EQ(messages.count(), 2);
    EXPECT_EQ(dWorldGetHybridBudget(stacks.world), dInfinity);
}

}  // namespace
}  // namespace epode::physics
