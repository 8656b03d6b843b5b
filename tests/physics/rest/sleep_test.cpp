// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sleeping and waking: a body with a joint falls asleep after its idle steps and stands still to the bit;
// what touches it awake wakes its whole island; the static world wakes nobody; bodies in free flight never
// sleep.
#include "rig.h"

namespace epode::physics {
namespace {

struct Sleep : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    Sleep()
    {
        sim.gravity(0, 0, -9.81);
        dWorldSetAutoDisableFlag(sim.world, 1);
        dWorldSetContactSurfaceLayer(sim.world, real(0.001));
        sim.ground();
    }
};

TEST_P(Sleep, takes_a_box_at_rest_and_keeps_it_still)
{
    dBodyID box = sim.box({0, 0, 0.25}, {0.5, 0.5, 0.5}, 1);
    sim.steps(100, 0.01);
    ASSERT_FALSE(dBodyIsEnabled(box));
    const std::uint64_t asleep = hash_state(sim);
    sim.steps(100, 0.01);
    EXPECT_EQ(hash_state(sim), asleep);
    EXPECT_EQ(length(velocity(box)), 0);
}

TEST_P(Sleep, comes_in_the_tenth_idle_step)
{
    sim.gravity(0, 0, 0);
    dBodyID b = sim.body({0, 0, 5});
    dJointAttach(dJointCreateNull(sim.world, nullptr), b, nullptr);
    for (int i = 1; i <= 9; ++i) {
        sim.advance(0.01);
        ASSERT_TRUE(dBodyIsEnabled(b)) << i;
    }
    sim.advance(0.01);
    EXPECT_FALSE(dBodyIsEnabled(b));
}

TEST_P(Sleep, never_takes_a_body_in_flight_nor_a_moving_one)
{
    sim.gravity(0, 0, 0);
    dBodyID flying = sim.body({0, 0, 5}), moving = sim.body({5, 0, 5});
    dJointAttach(dJointCreateNull(sim.world, nullptr), moving, nullptr);
    velocity(moving, {0.1, 0, 0});
    for (int i = 0; i < 100; ++i) sim.advance(0.01);
    EXPECT_TRUE(dBodyIsEnabled(flying)) << "no joint, no sleep";
    EXPECT_TRUE(dBodyIsEnabled(moving)) << "above the threshold of 0.01 m/s";
}

TEST_P(Sleep, ends_for_the_whole_stack_that_a_ball_hits)
{
    for (int i = 0; i < 3; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 1);
    dBodyID other = sim.box({10, 0, 0.25}, {0.5, 0.5, 0.5}, 1);
    sim.steps(400, 0.01);
    for (dBodyID b : sim.bodies) {
        if (dBodyIsEnabled(b)) dBodyDisable(b), velocity(b, {});  // a trembling one: put to bed
    }
    dBodyID ball = sim.sphere({0, 0, 2.2}, 0.3, 1);
    velocity(ball, {0, 0, -3});
    bool woken[3] = {false, false, false}, other_woken = false;
    for (int i = 0; i < 40; ++i) {
        sim.step(0.01);
        for (std::size_t k = 0; k < 3; ++k) woken[k] = woken[k] || dBodyIsEnabled(sim.bodies[k]);
        other_woken = other_woken || dBodyIsEnabled(other);
    }
    EXPECT_TRUE(woken[0] && woken[1] && woken[2]);
    EXPECT_FALSE(other_woken) << "the ground does not carry it on";
}

TEST_P(Sleep, is_left_alone_by_forces)
{
    dBodyID box = sim.box({0, 0, 0.25}, {0.5, 0.5, 0.5}, 1);
    dBodyDisable(box);
    dBodyAddForce(box, 0, 0, 1000);
    dBodyEnable(box);
    sim.step(0.01);
    EXPECT_NEAR(velocity(box).z, 10, 0.2) << "a force before the body wakes, in the same step";
    dBodyDisable(box);
    dBodyAddForce(box, 0, 0, 1000);
    sim.step(0.01);
    EXPECT_EQ(dBodyGetForce(box)[2], 0) << "its step is over";
    dWorldSetBehaviour(sim.world, dBehaviour016);
    dBodyAddForce(box, 0, 0, 1000);
    sim.step(0.01);
    EXPECT_EQ(dBodyGetForce(box)[2], 1000) << "ODE keeps it";
}

// Wind in every frame, by the body's functions and by a joint's, on a body that falls asleep by itself.
TEST_P(Sleep, collects_no_forces)
{
    sim.gravity(0, 0, 0);
    const dBodyID box = sim.box({0, 0, 3}, {0.5, 0.5, 0.5}, 1),
                  other = sim.box({5, 0, 3}, {0.5, 0.5, 0.5}, 1);
    const dJointID slider = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(slider, box, nullptr);
    dJointSetSliderAxis(slider, 1, 0, 0);
    dBodySetAutoDisableFlag(box, 1);
    dBodyDisable(other);
    for (int i = 0; i < 100; ++i) {
        dBodyAddForce(box, real(1e-6), 0, 0), dJointAddSliderForce(slider, real(1e-6));
        dBodyAddTorque(other, real(1e-6), 0, 0);
        sim.step(0.01);
    }
    ASSERT_FALSE(dBodyIsEnabled(box) || dBodyIsEnabled(other));
    EXPECT_EQ(dBodyGetForce(box)[0], 0);
    EXPECT_EQ(dBodyGetTorque(other)[0], 0);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Sleep, testing::ValuesIn(kSteppers), case_name);

// How far the top of a stack of ten boxes has moved after ten seconds of twelve sweeps per step.
double stack_after_ten_seconds(double warm_starting)
{
    Sim sim(Stepper::kQuick);
    sim.gravity(0, 0, -9.81);
    dWorldSetQuickStepNumIterations(sim.world, 12);
    dWorldSetStepWarmStarting(sim.world, real(warm_starting));
    dWorldSetContactSurfaceLayer(sim.world, real(0.001));
    sim.ground();
    for (int i = 0; i < 10; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 1);
    const V3 top = position(sim.bodies.back());
    sim.steps(1000, 0.01);
    return length(position(sim.bodies.back()) - top);
}

TEST(WarmStarting, keeps_a_stack_of_ten_standing_on_twelve_sweeps)
{
    const double warm = stack_after_ten_seconds(0.9), cold = stack_after_ten_seconds(0);
    EXPECT_LT(warm, 0.25) << "standing: the top is less than half a box away from its place";
    EXPECT_GT(cold, 4 * warm) << "without it the stack is lost";
}

TEST(WarmStarting, leaves_less_residual_to_the_same_sweeps)
{
    double residual[2];
    for (int k = 0; k < 2; ++k) {
        Sim sim(Stepper::kQuick);
        sim.gravity(0, 0, -9.81);
        dWorldSetStepReportMode(sim.world, 1);
        dWorldSetStepWarmStarting(sim.world, k == 0 ? real(0.9) : real(0));
        dWorldSetContactSurfaceLayer(sim.world, real(0.001));
        sim.ground();
        for (int i = 0; i < 6; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 1);
        sim.steps(50, 0.01);
        residual[k] = 0;
        for (int i = 0; i < 100; ++i) {
            sim.step(0.01);
            residual[k] += sim.report().residual / 100;
        }
    }
    EXPECT_LT(residual[0], 0.75 * residual[1]) << "mean over a second";
}

}  // namespace
}  // namespace epode::physics
