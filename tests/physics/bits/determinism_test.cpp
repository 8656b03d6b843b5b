// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The same calls give the same bits: in a second run of the process, after other worlds have come and gone
// (other addresses, other serial numbers), on several threads at once, and, for double precision, on every
// compiler and machine: the golden hashes of the newest behaviour.
#include <thread>

#include "golden/golden.h"
#include "scenes.h"

namespace epode::physics {
namespace {

std::uint64_t run(Scene scene, Stepper stepper, std::uint32_t seed = 1)
{
    Sim sim(stepper);
    build(sim, scene, seed);
    sim.steps(steps_of(scene), 0.01);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

TEST(Determinism, gives_the_same_bits_on_every_compiler)
{
    if (kSingle) GTEST_SKIP() << "the table is that of double precision";
    for (const Scene scene : kScenes)
        for (const Stepper stepper : kSteppers)
            EXPECT_TRUE(golden::is_golden(
                std::string("physics/behaviour_1/") + name_of(scene) + '/' + name_of(stepper),
                run(scene, stepper)));
}

constexpr int kThreadCounts[] = {2, 3, 5, 8};

TEST(Threads, a_step_has_the_same_bits_on_any_number_of_them)
{
    const auto hash = [](Scene scene, Stepper stepper, int threads) {
        Sim sim(stepper);
        dWorldSetStepThreads(sim.world, threads);
        build(sim, scene, 2);
        sim.steps(steps_of(scene) / 3, 0.01);
        return hash_state(sim);
    };
    for (Scene scene : kScenes)
        for (Stepper stepper : kSteppers) {
            const std::uint64_t alone = hash(scene, stepper, 1);
            for (int threads : kThreadCounts)
                EXPECT_EQ(hash(scene, stepper, threads), alone)
                    << name_of(scene) << ' ' << name_of(stepper) << ' ' << threads;
        }
}

std::vector<double> reports_of_many_islands(Stepper stepper, int threads)
{
    Sim sim(stepper);
    dWorldSetStepThreads(sim.world, threads);
    dWorldSetStepReportMode(sim.world, 1);
    sim.gravity(0, 0, -9.81);
    sim.ground();
    Random random(3);
    for (int i = 0; i < 150; ++i) {
        const dBodyID box = sim.box({3.0 * i, 0, 0.5}, {1, 1, 1}, 1 + i % 7);
        const V3 spin = random.point(1), way = random.point(1);  // in this order with every compiler
        velocity(box, way, spin);
        if (i % 3 == 0) sim.box({3.0 * i, 0, 1.5}, {1, 1, 1}, 1);
    }
    std::vector<double> all;
    for (int step = 0; step < 8; ++step) {
        sim.step(0.01);
        const dWorldStepReport total = sim.report();
        EXPECT_GE(total.islands, 150);
        all.insert(all.end(), {total.residual, total.energy_before, total.energy_after, total.penetration});
        for (int i = 0; i < total.islands; ++i) {
            dIslandStepReport one{};
            one.struct_size = sizeof one;
            EXPECT_EQ(dWorldGetIslandStepReport(sim.world, i, &one), 1);
            all.insert(all.end(), {double(one.rows), one.residual, one.energy_after, double(one.method)});
        }
    }
    all.push_back(double(hash_state(sim)));
    return all;
}

TEST(Threads, many_islands_report_the_same_on_any_number_of_them)
{
    for (Stepper stepper : kSteppers) {
        const std::vector<double> alone = reports_of_many_islands(stepper, 1);
        for (int threads : kThreadCounts) EXPECT_EQ(reports_of_many_islands(stepper, threads), alone);
    }
}

TEST(Determinism, gives_the_same_bits_again)
{
    for (Scene scene : kScenes)
        for (Stepper stepper : kSteppers)
            EXPECT_EQ(run(scene, stepper), run(scene, stepper)) << name_of(scene) << ' ' << name_of(stepper);
}

TEST(Determinism, different_scenes_have_different_hashes)
{
    EXPECT_NE(run(Scene::kPile, Stepper::kQuick, 1), run(Scene::kPile, Stepper::kQuick, 2));
}

TEST(Determinism, does_not_depend_on_the_worlds_that_were_before)
{
    for (Scene scene : kScenes)
        for (Stepper stepper : kSteppers) {
            const std::uint64_t first = run(scene, stepper);
            // Others live while it runs, some have gone: free memory and serial numbers are others.
            Sim other(Stepper::kQuick), another(Stepper::kExact);
            build(other, Scene::kPile, 5);
            build(another, Scene::kMachine, 6);
            other.steps(7, 0.01);
            for (int i = 0; i < 20; i += 3) dBodyDestroy(other.bodies[std::size_t(i)]);
            {
                Sim gone(Stepper::kFast);
                build(gone, Scene::kWall, 7);
                gone.steps(3, 0.01);
            }
            dRandSetSeed(12345);
            EXPECT_EQ(run(scene, stepper), first) << name_of(scene) << ' ' << name_of(stepper);
        }
}

TEST(Determinism, holds_when_the_steppers_take_turns)
{
    std::uint64_t hash[2];
    for (std::uint64_t& each : hash) {
        Sim sim;
        build(sim, Scene::kPile);
        for (int i = 0; i < 120; ++i) {
            sim.stepper = kSteppers[i % 3];
            sim.step(0.01);
        }
        each = hash_state(sim);
    }
    EXPECT_EQ(hash[0], hash[1]);
}

TEST(Threads, worlds_of_their_own_give_the_bits_of_a_single_thread)
{
    constexpr int kThreads = 4;
    const auto work = [](int number) {
        std::uint64_t all = 0;
        for (Stepper stepper : kSteppers) {
            Sim sim(stepper);
            build(sim, kScenes[number % 3], std::uint32_t(number) + 1);
            sim.steps(60, 0.01);
            all = all * 31 + hash_state(sim);
        }
        return all;
    };
    std::uint64_t alone[kThreads], together[kThreads];
    for (int i = 0; i < kThreads; ++i) alone[i] = work(i);
    for (int round = 0; round < 2; ++round) {
        std::vector<std::thread> threads;
        for (int i = 0; i < kThreads; ++i)
            threads.emplace_back([&, i] {
                dAllocateODEDataForThread(dAllocateMaskAll);
                together[i] = work(i);
                dCleanupODEAllDataForThread();
            });
        for (std::thread& thread : threads) thread.join();
        for (int i = 0; i < kThreads; ++i) EXPECT_EQ(together[i], alone[i]) << "thread " << i;
    }
}

}  // namespace
}  // namespace epode::physics
