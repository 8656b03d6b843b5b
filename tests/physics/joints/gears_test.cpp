// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Wheels on hinges, coupled by a transmission, in every stepper: speeds keep the ratio, energy is not made,
// play stays within its bounds, torque is multiplied by the ratio.
#include "rig.h"

namespace epode::physics {
namespace {

struct Wheels : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    dBodyID wheel[2];
    dJointID hinge[2], gear = dJointCreateTransmission(sim.world, nullptr);

    void place(int i, V3 at, V3 axis)
    {
        wheel[i] = sim.body(at);
        hinge[i] = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge[i], wheel[i], nullptr);
        dJointSetHingeAnchor(hinge[i], real(at.x), real(at.y), real(at.z));
        dJointSetHingeAxis(hinge[i], real(axis.x), real(axis.y), real(axis.z));
        if (i == 0) return;
        dJointAttach(gear, wheel[0], wheel[1]);
    }
    // Radii 2 and 1.
    void parallel()
    {
        place(0, {0, 0, 0}, {0, 0, 1});
        place(1, {0, 3, 0}, {0, 0, 1});
        dJointSetTransmissionAxis(gear, 0, 0, 1);
        dJointSetTransmissionRatio(gear, 2);
    }
    // Turning the same way, radii 2 and 1.
    void chain()
    {
        place(0, {1, 1, 0}, {0, 0, 1});
        place(1, {1, 5, 0}, {0, 0, 1});
        dJointSetTransmissionMode(gear, dTransmissionChainDrive);
        dJointSetTransmissionAxis(gear, 0, 0, 1);
        dJointSetTransmissionRadius1(gear, 2);
        dJointSetTransmissionRadius2(gear, 1);
    }
    // Radii 2 and 1; the second axis at right angles, pointing either way.
    void bevel(double way)
    {
        place(0, {0, 0, 0}, {0, 0, 1});
        place(1, {2, 0, 1}, {way, 0, 0});
        dJointSetTransmissionMode(gear, dTransmissionIntersectingAxes);
        dJointSetTransmissionAxis1(gear, 0, 0, 1);
        dJointSetTransmissionAxis2(gear, real(way), 0, 0);
    }
    double rate(int i) const { return double(dJointGetHingeAngleRate(hinge[i])); }
    // Turned free, and let run: signed ratio of the speeds.
    void expect_ratio(double ratio)
    {
        velocity(wheel[0], {}, {0, 0, 4});
        sim.advance(0.01);
        const double after = kinetic_energy(wheel[0]) + kinetic_energy(wheel[1]);
        EXPECT_LT(after, 8.0001);
        for (int i = 0; i < 300; ++i) sim.advance(0.01);
        EXPECT_NEAR(rate(1), ratio * rate(0), 0.02 * std::fabs(rate(0)));
        EXPECT_NEAR(std::fabs(rate(0)), 0.8, 0.05) << "unit inertias, speeds 1 : 2";
        EXPECT_NEAR(kinetic_energy(wheel[0]) + kinetic_energy(wheel[1]), after, 0.03 * after);
    }
};

// Forces act on one line even where nothing holds the wheels, so there is no gap that could turn the pair.
TEST_P(Wheels, in_free_flight_keep_momentum)
{
    for (int mode = 0; mode < 3; ++mode) {
        Sim free(GetParam());
        free.substeps = 1;
        dBodyID a = free.body({0, 0, 0}, 2, 1), b = free.body({1, 0.2, -0.3}, 1, 0.5);
        velocity(a, {1, 2, -1}, {2, -1, 3});
        velocity(b, {-1, 0.5, 1}, {1, 2, -2});
        dJointID j = dJointCreateTransmission(free.world, nullptr);
        dJointAttach(j, a, b);
        dJointSetTransmissionMode(j, mode);
        if (mode == dTransmissionIntersectingAxes) {
            dJointSetTransmissionAxis1(j, 0, 0, 1);
            dJointSetTransmissionAxis2(j, 1, 0, 0);
        } else {
            dJointSetTransmissionAxis(j, 0, 0, 1);
        }
        if (mode == dTransmissionChainDrive) {
            dJointSetTransmissionRadius1(j, real(0.3));
            dJointSetTransmissionRadius2(j, real(0.2));
        }
        const V3 p = momentum(free), L = angular_momentum(free);
        for (int i = 0; i < 20; ++i) free.advance(0.004);
        EXPECT_LT(length(momentum(free) - p), 2e4 * kEpsilon) << mode;
        // The relax pass of substeps applies the rows of the pose before to the pose after: first order in
        // h for every joint (momentum_test.cpp).
        if (GetParam() == Stepper::kFast) continue;
        EXPECT_LT(length(angular_momentum(free) - L), 2e4 * kEpsilon) << mode;
    }
}

TEST_P(Wheels, of_parallel_gears_turn_against_each_other)
{
    parallel();
    expect_ratio(-2);
}

TEST_P(Wheels, of_a_chain_turn_alike)
{
    chain();
    expect_ratio(2);
}

TEST_P(Wheels, of_a_bevel_gear_turn_as_their_axes_point)
{
    bevel(1);
    expect_ratio(2);
}

TEST_P(Wheels, of_a_bevel_gear_turn_as_their_axes_point_against)
{
    bevel(-1);
    expect_ratio(-2);
}

TEST_P(Wheels, multiply_torque)
{
    parallel();
    for (int i = 0; i < 100; ++i) {
        dJointAddHingeTorque(hinge[0], 4);
        dJointAddHingeTorque(hinge[1], 2);  // half the torque, against it, holds it at half the radius
        sim.advance(0.01);
    }
    EXPECT_NEAR(rate(0), 0, 1e-3);
    EXPECT_NEAR(rate(1), 0, 1e-3);
    EXPECT_NEAR(double(dJointGetHingeAngle(hinge[0])), 0, 1e-3);
}

TEST_P(Wheels, stay_within_their_play)
{
    parallel();
    dJointSetTransmissionBacklash(gear, real(0.1));
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
        dJointAddHingeTorque(hinge[0], i % 100 < 50 ? 1 : -1);
        sim.advance(0.01);
        const double slip =
            2 * double(dJointGetTransmissionAngle1(gear)) + double(dJointGetTransmissionAngle2(gear));
        largest = std::max(largest, std::fabs(slip));
    }
    EXPECT_GT(largest, 0.09) << "or it had none";
    EXPECT_LT(largest, 0.15);
    dJointFeedback feedback{};
    dJointSetFeedback(gear, &feedback);
    sim.advance(0.01);
    EXPECT_TRUE(finite_state(sim));
}

TEST_P(Wheels, change_gear_under_way_without_a_jerk)
{
    parallel();
    velocity(wheel[0], {}, {0, 0, 4});
    double ratio = 2;
    for (int i = 0; i < 300; ++i) {
        ratio *= 0.995;
        dJointSetTransmissionRatio(gear, real(ratio));
        sim.advance(0.01);
        EXPECT_LT(std::fabs(rate(0)), 4);
        EXPECT_NEAR(rate(1), -ratio * rate(0), 0.1 * std::fabs(rate(0))) << i;
        if (testing::Test::HasFailure()) break;
    }
}

INSTANTIATE_TEST_SUITE_P(Steppers, Wheels, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
