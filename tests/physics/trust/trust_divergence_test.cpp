// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Five balls of 1 kg and 0.26 m hang together by hinges on arms of 2.4 to 6.6 m; two of them are jammed against each other
// with 3,600 N s, which the next step begins with although the balls have turned (jammed_chain.epw, a state that a soak has
// come to). No constraint makes energy: of 102 J a step that sweeps made 1e13. Two levers whose contacts and joint want to correct
// errors (jammed_levers.epw): what sweeps had made, 2e7 J, vouched for itself. Four bodies whose joints are near a dead centre
// (thrown_levers.epw): to close 5 mm the exact solution threw them with 1e5 J.
#include <ode/ext.h>

#include <algorithm>
#include <vector>

#include "rig.h"

// The file is of double precision, and lies where the tests were built.
#if !defined(dSINGLE) && !defined(_WIN32) && !defined(__EMSCRIPTEN__)
namespace epode::physics {
namespace {

constexpr dReal kStep = dReal(0.0166);
const char* const kChain = EPODE_PHYSICS "/trust/jammed_chain.epw";
const char* const kThrown = EPODE_PHYSICS "/trust/thrown_levers.epw";

dWorldID load(const char* file = kChain)
{
    dSpaceID space = nullptr;
    const dWorldID world = dWorldLoad(file, &space);
    EXPECT_TRUE(world);
    dWorldSetStepReportMode(world, 1);
    return world;
}

template <typename Step>
void expect_no_energy_from_nothing(Step&& step, double limit)
{
    for (int n = 1; n <= 32; n *= 2) {
        const dWorldID world = load();
        double before = 0, largest = 0;
        for (int i = 0; i < 60; ++i) {
            step(world, n);
            dWorldStepReport report{};
            report.struct_size = sizeof report;
            ASSERT_TRUE(dWorldGetStepReport(world, &report));
            EXPECT_EQ(report.contained_islands, 0);
            EXPECT_EQ(report.fallbacks, 0) << "solved twice: it began with impulses that make energy";
            if (i == 0) before = report.energy_before;
            largest = std::max(largest, report.energy_after);
        }
        EXPECT_LT(largest, limit * before) << "with " << n;
        dWorldDestroy(world);
    }
}

TEST(TrustDivergence, substeps_of_a_jammed_chain_make_no_energy)
{
    expect_no_energy_from_nothing([](dWorldID world, int n) { dWorldStepFast1(world, kStep, n); }, 1.1);
}

TEST(TrustDivergence, substeps_with_exact_joints_make_none)
{
    expect_no_energy_from_nothing(
        [](dWorldID world, int n) {
            dWorldSetHybridStepper(world, dStepperSubstepsExactJoints);
            dWorldSetHybridSubsteps(world, n);
            dWorldStepHybrid(world, kStep);
        },
        1.3);
}

// What sweeps make in a step is believed up to twice the energy of the motion.
TEST(TrustDivergence, quick_steps_make_no_more_than_they_are_believed)
{
    expect_no_energy_from_nothing(
        [](dWorldID world, int n) {
            dWorldSetQuickStepNumIterations(world, 5 * n);
            dWorldQuickStep(world, kStep);
        },
        12);
}

TEST(TrustDivergence, is_reported_and_no_other_island_changes)
{
    const auto neighbour = [](bool alone) {
        const dWorldID world = alone ? dWorldCreate() : load(kThrown);
        dWorldSetStepReportMode(world, 1);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dBodyID bodies[2];
        for (dBodyID& body : bodies) body = dBodyCreate(world);
        dBodySetPosition(bodies[0], 100, 0, 0), dBodySetPosition(bodies[1], 101, 0, 0);
        dBodySetAngularVel(bodies[1], 1, 2, 3);
        const dJointID ball = dJointCreateBall(world, nullptr);
        dJointAttach(ball, bodies[0], bodies[1]);
        dJointSetBallAnchor(ball, dReal(100.3), 0, dReal(0.2));
        dWorldStepFast1(world, dReal(0.05), 50);
        dWorldStepReport sum{};
        sum.struct_size = sizeof sum;
        EXPECT_TRUE(dWorldGetStepReport(world, &sum));
        EXPECT_EQ(sum.fallbacks, alone ? 0 : 1);
        const dReal* w = dBodyGetAngularVel(bodies[1]);
        const std::vector<dReal> out(w, w + 3);
        dWorldDestroy(world);
        return out;
    };
    EXPECT_EQ(neighbour(false), neighbour(true));
}

// With all steppers and step sizes: a step gains at most the energy of what errors of position ask for.
void expect_small_gains(const char* file, double limit)
{
    for (int stepper = 0; stepper < 4; ++stepper)
        for (const dReal h : {dReal(0.002), dReal(0.005), kStep}) {
            const dWorldID world = load(file);
            for (int i = 0; i < 30; ++i) {
                stepper == 0   ? dWorldStep(world, h)
                : stepper == 1 ? dWorldStepHybrid(world, h)
                : stepper == 2 ? dWorldQuickStep(world, h)
                               : dWorldStepFast1(world, h, 3);
                dWorldStepReport report{};
                report.struct_size = sizeof report;
                ASSERT_TRUE(dWorldGetStepReport(world, &report));
                EXPECT_EQ(report.contained_islands, 0);
                EXPECT_LT(report.energy_after, report.energy_before + limit)
                    << "stepper " << stepper << ", " << h << ", step " << i;
            }
            dWorldDestroy(world);
        }
}

TEST(TrustDivergence, what_sweeps_have_made_does_not_vouch_for_itself)
{
    expect_small_gains(EPODE_PHYSICS "/trust/jammed_levers.epw", 1000);
}

TEST(TrustDivergence, corrections_near_a_dead_centre_throw_nothing) { expect_small_gains(kThrown, 5000); }

}  // namespace
}  // namespace epode::physics
#endif
