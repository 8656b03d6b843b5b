// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Motors and stops. A motor changes the speed by FMax h / m per step until it has the wanted one; a stop
// takes the speed, gives back its bounce, and closes a violation by ERP per step; a motor against its stop
// holds with FMax.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kRounding = 200 * kEpsilon;

struct Motor : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    dBodyID b = sim.body({0, 0, 0}, 2, 3);
    Motor()
    {
        dWorldSetQuickStepW(sim.world, 1);  // one row per direction: one sweep is exact
        dWorldSetCFM(sim.world, 0);
        sim.substeps = 4;
    }

    dJointID slider()
    {
        dJointID j = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(j, b, nullptr);
        dJointSetSliderAxis(j, 1, 0, 0);
        return j;
    }
    dJointID hinge()
    {
        dJointID j = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(j, b, nullptr);
        dJointSetHingeAnchor(j, 0, 0, 0);
        dJointSetHingeAxis(j, 0, 0, 1);
        return j;
    }
};

TEST_P(Motor, speeds_a_slider_up_by_fmax_h_over_m)
{
    dJointID j = slider();
    dJointSetSliderParam(j, dParamVel, real(0.9));
    dJointSetSliderParam(j, dParamFMax, 8);
    const double h = 0.01;
    for (int i = 1; i <= 40; ++i) {
        sim.advance(h);
        ASSERT_NEAR(velocity(b).x, std::min(0.9, i * 8 * h / 2), kRounding) << "step " << i;
    }
    EXPECT_NEAR(dJointGetSliderPositionRate(j), 0.9, kRounding);
}

TEST_P(Motor, speeds_a_hinge_up_by_fmax_h_over_inertia)
{
    dJointID j = hinge();
    dJointSetHingeParam(j, dParamVel, real(-2));
    dJointSetHingeParam(j, dParamFMax, 6);
    const double h = 0.02;
    for (int i = 1; i <= 80; ++i) {
        sim.advance(h);
        ASSERT_NEAR(spin(b).z, std::max(-2.0, -i * 6 * h / 3), kRounding) << "step " << i;
    }
    EXPECT_NEAR(dJointGetHingeAngleRate(j), -2, kRounding);
}

TEST_P(Motor, a_stop_ends_the_journey)
{
    dJointID j = slider();
    dJointSetSliderParam(j, dParamLoStop, real(-0.5));
    dJointSetSliderParam(j, dParamHiStop, real(0.5));
    dJointSetSliderParam(j, dParamStopERP, 0);  // with ERP it would be sent back at the correcting speed
    dJointSetSliderParam(j, dParamStopCFM, 0);
    velocity(b, {3, 0, 0});
    for (int i = 0; i < 100; ++i) sim.advance(0.01);
    EXPECT_GT(position(b).x, 0.5 - 1e-6);
    EXPECT_LT(position(b).x, 0.5 + 3 * 0.01 + 1e-6) << "found beyond by less than a step";
    EXPECT_NEAR(velocity(b).x, 0, kRounding);
}

TEST_P(Motor, a_stop_gives_back_its_bounce)
{
    dJointID j = slider();
    dJointSetSliderParam(j, dParamLoStop, -1);
    dJointSetSliderParam(j, dParamHiStop, 0);
    dJointSetSliderParam(j, dParamBounce, real(0.5));
    dJointSetSliderParam(j, dParamStopCFM, 0);
    velocity(b, {4, 0, 0});
    sim.advance(0.01);
    EXPECT_NEAR(velocity(b).x, -2, kRounding);
}

TEST_P(Motor, a_violated_stop_closes_by_erp_per_step)
{
    if (GetParam() == Stepper::kFast) GTEST_SKIP() << "takes the correcting velocity out again";
    dJointID j = slider();
    dJointSetSliderParam(j, dParamLoStop, 1);
    dJointSetSliderParam(j, dParamHiStop, 1);
    dJointSetSliderParam(j, dParamStopERP, real(0.25));
    dJointSetSliderParam(j, dParamStopCFM, 0);
    place(b, {1.8, 0, 0});
    double beyond = 0.8;
    for (int i = 0; i < 20; ++i) {
        // Held from both sides, the speed is erp / h times the distance in every step, the last one
        // forgotten.
        sim.advance(0.01);
        beyond *= 0.75;
        ASSERT_NEAR(position(b).x, 1 + beyond, 100 * kEpsilon) << "step " << i;
    }
}

TEST_P(Motor, holds_a_load_below_fmax_and_yields_to_one_above)
{
    dJointID j = slider();
    dJointSetSliderParam(j, dParamVel, 0);
    dJointSetSliderParam(j, dParamFMax, 10);
    for (int i = 0; i < 50; ++i) {
        dBodyAddForce(b, real(9.5), 0, 0);
        sim.advance(0.01);
    }
    EXPECT_NEAR(velocity(b).x, 0, kRounding);
    const double before = velocity(b).x;
    for (int i = 0; i < 50; ++i) {
        dBodyAddForce(b, 14, 0, 0);
        sim.advance(0.01);
    }
    EXPECT_NEAR(velocity(b).x - before, (14 - 10) / 2.0 * 0.5, kRounding * 50);
}

TEST_P(Motor, a_hinge_stop_carries_a_beam)
{
    const double mass = 2, arm = 0.7, g = 9.81;
    sim.gravity(0, 0, -g);
    place(b, {arm, 0, 0});
    dJointID j = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(j, b, nullptr);
    dJointSetHingeAnchor(j, 0, 0, 0);
    dJointSetHingeAxis(j, 0, 1, 0);
    dJointSetHingeParam(j, dParamLoStop, 0);
    dJointSetHingeParam(j, dParamHiStop, 0);
    dJointFeedback feedback{};
    dJointSetFeedback(j, &feedback);
    dWorldSetQuickStepNumIterations(sim.world, 200);
    for (int i = 0; i < 300; ++i) sim.advance(0.01);
    EXPECT_NEAR(position(b).z, 0, 2e-3);
    EXPECT_NEAR(feedback.f1[2], mass * g, 0.02 * mass * g);
    // At the body: the hinge's force turns it about its centre, the stop holds against that.
    EXPECT_NEAR(feedback.t1[1], 0, 0.02 * mass * g * arm);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Motor, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
