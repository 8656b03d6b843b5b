// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Behaviour versions (dWorldSetBehaviour): each number is frozen by golden hashes, in double precision; 0.16
// draws from dRand, sweeps and sleeps as ODE documents it (tests/parity compares it with Debian's library);
// results do not depend on threads or batches; a state goes on with the same bits if the seed is kept, too.
#include <algorithm>

#include "golden/golden.h"
#include "scenes.h"

namespace epode::physics {
namespace {

constexpr int kVersions[] = {dBehaviour016, dBehaviour1};

struct Versioned : Sim {
    Versioned(int version, Stepper how) : Sim(how)
    {
        dRandSetSeed(0);
        dWorldSetBehaviour(world, version);
    }
};

std::uint64_t run(int version, Scene scene, Stepper stepper)
{
    Versioned sim(version, stepper);
    build(sim, scene);
    sim.steps(steps_of(scene), 0.01);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

// Bodies that come to rest, in both ways of contacts.
std::uint64_t sleep(int version, Stepper stepper, bool world_contacts)
{
    Versioned sim(version, stepper);
    if (world_contacts) dWorldSetContactSpace(sim.world, sim.space);
    dWorldSetAutoDisableFlag(sim.world, 1);
    dWorldSetAutoDisableLinearThreshold(sim.world, real(0.05));
    dWorldSetAutoDisableAngularThreshold(sim.world, real(0.05));
    sim.gravity(0, 0, -9.81);
    sim.surface.mode = dContactApprox1;
    sim.surface.mu = real(0.6);
    sim.ground();
    for (int i = 0; i < 12; ++i) sim.box({0.7 * (i % 3), 0.1 * i, 0.3 + 0.45 * (i / 3)}, {0.6, 0.5, 0.4}, 1);
    for (int i = 0; i < 200; ++i) {
        if (world_contacts) {
            sim.advance(0.01);
        } else {
            sim.step(0.01);
        }
    }
    std::uint64_t asleep = 0;
    for (dBodyID b : sim.bodies) asleep += !dBodyIsEnabled(b);
    return hash_state(sim) ^ asleep;
}

TEST(Behaviour, is_frozen)
{
    if (kSingle) GTEST_SKIP() << "the table is that of double precision";
    for (const int version : kVersions) {
        const std::string family =
            version == dBehaviour016 ? "physics/behaviour_016/" : "physics/behaviour_1/";
        for (Stepper stepper : kSteppers) {
            for (Scene scene : kScenes)
                EXPECT_TRUE(golden::is_golden(family + name_of(scene) + '/' + name_of(stepper),
                                              run(version, scene, stepper)));
            const std::string sleeping = family + "sleep/" + name_of(stepper);
            EXPECT_TRUE(golden::is_golden(sleeping, sleep(version, stepper, false)));
            EXPECT_TRUE(golden::is_golden(sleeping + "/world_contacts", sleep(version, stepper, true)));
        }
    }
}

TEST(Behaviour, of_a_new_world_is_the_newest_and_can_be_changed_between_steps)
{
    Sim sim(Stepper::kQuick);
    EXPECT_EQ(dWorldGetBehaviour(sim.world), dBehaviour1);
    build(sim, Scene::kPile);
    for (int i = 0; i < 40; ++i) {
        dWorldSetBehaviour(sim.world, i % 2 ? dBehaviour1 : dBehaviour016);
        EXPECT_EQ(dWorldGetBehaviour(sim.world), i % 2 ? 100 : 16);
        EXPECT_EQ(sim.step(0.01), 1);
    }
    EXPECT_TRUE(finite_state(sim));
}

TEST(Behaviour, that_does_not_exist_is_refused)
{
    Sim sim;
    Messages messages;
    for (int version : {0, 1, 15, 17, 99, 101, -16}) {
        dWorldSetBehaviour(sim.world, version);
        EXPECT_EQ(dWorldGetBehaviour(sim.world), dBehaviour1);
    }
    EXPECT_EQ(messages.count(), 7);
    EXPECT_NE(messages.last().find("dBehaviour"), std::string::npos) << messages.last();
    EXPECT_EQ(dWorldGetBehaviour(nullptr), 0);
    EXPECT_EQ(messages.count(), 8);
}

// ---- 0.16

// The guide's numbers for ODE: one hinge has five rows, twenty sweeps shuffle them twice.
TEST(Behaviour, of_ode_draws_from_the_process_what_ode_draws)
{
    Versioned sim(dBehaviour016, Stepper::kQuick);
    sim.gravity(0, 0, -9.81);
    const dBodyID bob = sim.body({1, 0, 0});
    const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, bob, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    sim.advance(0.01);
    const unsigned long drawn = dRandGetSeed();
    dRandSetSeed(0);
    for (int i = 0; i < 8; ++i) dRand();
    EXPECT_EQ(drawn, dRandGetSeed());
    for (int i = 1; i < 100; ++i) sim.advance(0.01);
    EXPECT_NEAR(position(bob).x, -0.49034019271, tol(1e-10, 1e-4));
    EXPECT_NEAR(position(bob).z, -0.874064053068, tol(1e-10, 1e-4));
}

TEST(Behaviour, of_today_draws_nothing)
{
    for (Stepper stepper : kSteppers) {
        Versioned sim(dBehaviour1, stepper);
        build(sim, Scene::kMachine);
        sim.steps(5, 0.01);
        EXPECT_EQ(dRandGetSeed(), 0u);
    }
}

TEST(Behaviour, of_ode_has_the_same_bits_on_any_number_of_threads)
{
    for (Stepper stepper : kSteppers)
        for (Scene scene : kScenes) {
            std::uint64_t hash[2];
            for (int threads : {1, 4}) {
                Versioned sim(dBehaviour016, stepper);
                dWorldSetStepThreads(sim.world, threads);
                build(sim, scene);
                sim.steps(60, 0.01);
                hash[threads > 1] = hash_state(sim);
            }
            EXPECT_EQ(hash[0], hash[1]) << name_of(scene) << ' ' << name_of(stepper);
        }
}

TEST(Behaviour, of_ode_in_a_batch_is_that_of_worlds_stepped_in_its_order)
{
    std::uint64_t alone[3], together[3];
    {
        Versioned a(dBehaviour016, Stepper::kQuick), b(dBehaviour016, Stepper::kQuick),
            c(dBehaviour016, Stepper::kQuick);
        Sim* const sims[] = {&a, &b, &c};
        for (Sim* sim : sims) build(*sim, Scene::kMachine);
        for (int i = 0; i < 30; ++i)
            for (Sim* sim : sims) sim->advance(0.01);
        for (int i = 0; i < 3; ++i) alone[i] = hash_state(*sims[i]);
    }
    Versioned a(dBehaviour016, Stepper::kQuick), b(dBehaviour016, Stepper::kQuick),
        c(dBehaviour016, Stepper::kQuick);
    Sim* const sims[] = {&a, &b, &c};
    for (Sim* sim : sims) build(*sim, Scene::kMachine);
    const dWorldID worlds[] = {a.world, b.world, c.world};
    for (int i = 0; i < 30; ++i)
        EXPECT_EQ(dWorldsStep(worlds, 3, real(0.01), dStepperQuick, 20, 1, 4, nullptr), 3);
    for (int i = 0; i < 3; ++i) together[i] = hash_state(*sims[i]);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(alone[i], together[i]);
    EXPECT_NE(alone[0], alone[1]);  // they share the generator
}

TEST(Behaviour, of_ode_goes_on_from_a_state_if_the_seed_is_kept)
{
    Versioned sim(dBehaviour016, Stepper::kQuick);
    build(sim, Scene::kPile);
    sim.steps(20, 0.01);
    dJointGroupEmpty(sim.contacts);
    std::vector<char> state(dWorldGetStateSize(sim.world));
    ASSERT_NE(dWorldGetState(sim.world, state.data(), state.size()), 0);
    const unsigned long seed = dRandGetSeed();
    sim.steps(20, 0.01);
    const std::uint64_t first = hash_state(sim);
    dJointGroupEmpty(sim.contacts);
    ASSERT_EQ(dWorldSetState(sim.world, state.data(), state.size()), 1);
    dRandSetSeed(seed);
    sim.steps(20, 0.01);
    EXPECT_EQ(hash_state(sim), first);
    EXPECT_EQ(dWorldGetBehaviour(sim.world), dBehaviour016);
}

// What is idle stops although its neighbour moves, and is woken by it.
TEST(Behaviour, of_ode_lets_bodies_fall_asleep_one_by_one)
{
    for (int version : kVersions) {
        Versioned sim(version, Stepper::kExact);
        dWorldSetAutoDisableFlag(sim.world, 1);
        const dBodyID slow = sim.body({0, 0, 0}), quick = sim.body({1, 0, 0});
        const dJointID null = dJointCreateNull(sim.world, nullptr);
        dJointAttach(null, slow, quick);
        velocity(slow, {0, 0.005, 0});
        velocity(quick, {0, 1, 0});
        for (int i = 0; i < 12; ++i) sim.advance(0.01);
        EXPECT_TRUE(dBodyIsEnabled(slow));
        EXPECT_EQ(velocity(slow).y > 0, version == dBehaviour1) << version;
    }
}

TEST(Behaviour, of_ode_reports_a_residual_and_takes_couplings)
{
    Versioned sim(dBehaviour016, Stepper::kQuick);
    build(sim, Scene::kMachine);
    dWorldSetStepReportMode(sim.world, 1);
    sim.steps(10, 0.01);
    EXPECT_GT(sim.report().residual, 0);
    EXPECT_LT(sim.report().residual, 1);
    const dBodyID a = sim.body({50, 0, 0}), b = sim.body({52, 0, 0});
    dJointID hinges[2];
    for (int i = 0; i < 2; ++i) {
        hinges[i] = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinges[i], i ? b : a, nullptr);
        dJointSetHingeAxis(hinges[i], 0, 0, 1);
    }
    const dJointID gear = dJointCreateCoupling(sim.world, nullptr);
    dJointSetCouplingAxis(gear, 0, hinges[0], 0, 1);
    dJointSetCouplingAxis(gear, 1, hinges[1], 0, -1);
    velocity(a, {}, {0, 0, 1});
    sim.steps(20, 0.01);
    EXPECT_NEAR(spin(a).z, spin(b).z, 0.02);
    EXPECT_NEAR(spin(a).z, 0.5, 0.05);
}

}  // namespace
}  // namespace epode::physics
