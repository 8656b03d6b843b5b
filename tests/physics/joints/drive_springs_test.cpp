// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Springs in physical units in the place of ERP and CFM: stops, a ball's anchor, a suspension. Stiffness and
// damping are those given at every step size and in every way to step, where ERP and CFM would be others.
#include "drive_ways.h"

namespace epode::physics {
namespace {

struct Springs : testing::TestWithParam<Way> {};

dJointID slider(Sim& sim, dBodyID b, double low, double high)
{
    dJointID joint = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(joint, b, nullptr);
    dJointSetSliderAxis(joint, 1, 0, 0);
    dJointSetSliderParam(joint, dParamLoStop, real(low));
    dJointSetSliderParam(joint, dParamHiStop, real(high));
    return joint;
}

TEST_P(Springs, equal_stops_are_the_implicit_spring)
{
    DrivenAxis axis;
    axis.mass = 2, axis.other_force = 3;
    axis.drive.stiffness = 300, axis.drive.damping = 4;
    Sim sim;
    dWorldSetQuickStepW(sim.world, 1);
    dBodyID b = sim.body({0, 0, 0}, axis.mass);
    dJointID joint = slider(sim, b, 0, 0);
    ASSERT_EQ(dJointSetStopSpring(joint, 0, axis.drive.stiffness, axis.drive.damping), 1);
    double q = 0.3, w = -1;
    place(b, {q, 0, 0});
    velocity(b, {w, 0, 0});
    const int parts = parts_of(GetParam());
    sim.gravity(axis.other_force / axis.mass, 0, 0);  // a program's force is a kick, where it moves something
    for (int i = 0; i < 100; ++i) {
        step(sim, GetParam(), 0.01);
        for (int k = 0; k < parts; ++k) w = axis.next_rate(q, w, 0.01 / parts), q += 0.01 / parts * w;
        ASSERT_NEAR(velocity(b).x, w, tol(1e-9, 2e-4)) << "step " << i;
        ASSERT_NEAR(position(b).x, q, tol(1e-9, 2e-4)) << "step " << i;
    }
}

// A body thrown at a soft stop: how deep it goes is v sqrt(m/k), and it comes back with its speed.
double depth_of_throw(Way way, double h)
{
    Sim sim;
    dBodyID b = sim.body({0, 0, 0}, 2);
    dJointID joint = slider(sim, b, -dInfinity, 1);
    dJointSetStopSpring(joint, 0, 200, 0);
    velocity(b, {1, 0, 0});
    double deepest = 0;
    for (int i = 0; i * h < 2; ++i) step(sim, way, h), deepest = std::max(deepest, position(b).x - 1);
    EXPECT_LT(velocity(b).x, -0.5);
    return deepest;
}

TEST_P(Springs, halving_the_step_converges_at_first_order)
{
    const double exact = std::sqrt(2.0 / 200);
    double before = 0;
    for (int k = 0; k < 5; ++k) {
        const double off = std::fabs(depth_of_throw(GetParam(), 0.008 / (1 << k)) - exact);
        if (k > 1) { EXPECT_LT(off, 0.75 * before + tol(1e-6, 1e-4)) << "halved " << k << " times"; }
        before = off;
    }
    EXPECT_LT(before, 0.03 * exact);
}

TEST_P(Springs, give_way_by_load_over_stiffness_at_any_step)
{
    for (const double h : {0.02, 0.01, 0.0025}) {
        Sim sim;
        sim.gravity(0, 0, -10);
        dBodyID hung = sim.body({0, 0, 0}, 2);
        dJointID ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, hung, nullptr);
        dJointSetBallAnchor(ball, 0, 0, 0);
        ASSERT_EQ(dJointSetSpring(ball, 400, 60), 1);
        step(sim, GetParam(), h, int(6 / h));
        EXPECT_NEAR(position(hung).z, -20.0 / 400, 1e-5) << h;
    }
}

TEST_P(Springs, carry_a_chassis_on_its_suspension)
{
    for (const double h : {0.02, 0.005}) {
        Sim sim;
        sim.gravity(0, 0, -10);
        dBodyID chassis = sim.body({0, 0, 1}, 5), wheel = sim.body({0, 0, 0}, 1);
        dJointID fixed = dJointCreateFixed(sim.world, nullptr),
                 guide = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(fixed, wheel, nullptr);
        dJointSetFixed(fixed);
        dJointAttach(guide, chassis, nullptr);
        dJointSetSliderAxis(guide, 0, 0, 1);
        dJointID joint = dJointCreateHinge2(sim.world, nullptr);
        dJointAttach(joint, chassis, wheel);
        const dReal steer[4] = {0, 0, 1, 0}, spin[4] = {0, 1, 0, 0};
        dJointSetHinge2Anchor(joint, 0, 0, 0);
        dJointSetHinge2Axes(joint, steer, spin);
        ASSERT_EQ(dJointSetSpring(joint, 1000, 150), 1);
        step(sim, GetParam(), h, int(4 / h));
        EXPECT_NEAR(position(chassis).z, 1 - 50.0 / 1000,
                    GetParam() == Way::kSubsteps ? 1e-3 : tol(1e-5, 1e-4))
            << h;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, Springs, testing::ValuesIn(kWays), way_name);

TEST(SpringCalls, are_read_back_refused_and_taken_away)
{
    Sim sim;
    Messages messages;
    dBodyID b = sim.body({0, 0, 0});
    dJointID joint = slider(sim, b, 0, 0);
    dReal k = 7, d = 7;
    EXPECT_EQ(dJointGetStopSpring(joint, 0, &k, &d), 0);
    EXPECT_EQ(k, 0);
    EXPECT_EQ(dJointSetStopSpring(joint, 0, 5, 2), 1);
    EXPECT_EQ(dJointGetStopSpring(joint, 0, &k, &d), 1);
    EXPECT_EQ(k, 5);
    EXPECT_EQ(d, 2);
    EXPECT_EQ(messages.count(), 0);
    EXPECT_EQ(dJointSetStopSpring(joint, 0, -1, 2), 0);
    EXPECT_EQ(dJointSetStopSpring(joint, 1, 1, 2), 0);
    EXPECT_EQ(dJointSetSpring(joint, 1, 2), 0) << "a slider has no ERP of its own";
    EXPECT_EQ(messages.count(), 3);
    EXPECT_EQ(dJointSetStopSpring(joint, 0, 0, 0), 1);
    EXPECT_EQ(dJointGetStopSpring(joint, 0, &k, &d), 0);
    EXPECT_EQ(dSpringFromFrequency(2, real(0.5), 1, &k, &d), 1);
    EXPECT_NEAR(double(k), 2 * kPi * kPi, 1e-5);
    EXPECT_NEAR(double(d), 4 * kPi, 1e-5);
}

}  // namespace
}  // namespace epode::physics
