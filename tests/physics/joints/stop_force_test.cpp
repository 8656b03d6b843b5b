// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What stops exert (dJointGetStopForce), by statics, in every way to step: a carriage that its low stop bears, m g; a rod at its high
// stop, m g l, attached either way round; a coupling's stop; and how it is shared with a drive. Within stops it is 0.
#include <cmath>

#include "drive_ways.h"

namespace epode::physics {
namespace {

// All begin beyond their stops by kBeyond, of which 0.8^100 is left: where a stop is reached, rounding may let go of it for a step.
constexpr double kG = 9.81, kStep = 0.005, kBeyond = 0.01;

struct StopForces : testing::TestWithParam<Way> {
    StopForces()
    {
        sim.gravity(0, 0, -kG);
        dWorldSetCFM(sim.world, 0);
        dWorldSetQuickStepNumIterations(sim.world, 200);
    }
    // Along z, with its stops kBeyond and `high`.
    dJointID carriage(double mass, double high = 1)
    {
        const dBodyID body = sim.body({double(sim.bodies.size()), 0, 0}, mass);
        const dJointID slider = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(slider, body, nullptr);
        dJointSetSliderAxis(slider, 0, 0, 1);
        dJointSetSliderParam(slider, dParamHiStop, real(high));
        dJointSetSliderParam(slider, dParamLoStop, real(kBeyond));
        return slider;
    }
    void settle()
    {
        for (int i = 0; i < 100; ++i) step(sim, GetParam(), kStep);
    }
    static double force(dJointID joint) { return double(dJointGetStopForce(joint, 0)); }

    Sim sim;
};
INSTANTIATE_TEST_SUITE_P(Ways, StopForces, testing::ValuesIn(kWays), way_name);

TEST_P(StopForces, bear_what_rests_on_them)
{
    const dJointID slider = carriage(3), free = carriage(2);
    dJointSetSliderParam(free, dParamLoStop, real(-100));
    settle();
    EXPECT_NEAR(force(slider), 3 * kG, tol(1e-6, 1e-3));
    EXPECT_EQ(force(free), 0);
}

// A rod that lies nearly level on its stop. Of a hinge that is attached the other way round the angle as read runs the other way.
TEST_P(StopForces, of_hinges_act_along_the_angle_that_is_read)
{
    for (const bool reversed : {false, true}) {
        const dBodyID rod = sim.body({0.5, reversed ? 3.0 : 0.0, 0}, 2);
        const dJointID hinge = dJointCreateHinge(sim.world, nullptr);
        dJointAttach(hinge, reversed ? nullptr : rod, reversed ? rod : nullptr);
        dJointSetHingeAnchor(hinge, 0, reversed ? 3 : 0, 0);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        dJointSetHingeParam(hinge, dParamLoStop, -1);
        dJointSetHingeParam(hinge, dParamHiStop, real(-kBeyond));
        settle();
        // Gravity turns about +y: the angle would grow, or, read the other way, shrink.
        EXPECT_NEAR(force(hinge), (reversed ? 1 : -1) * 2 * kG * 0.5 * std::cos(kBeyond), tol(1e-5, 1e-2))
            << reversed;
    }
}

TEST_P(StopForces, leave_to_drives_what_those_exert)
{
    const dJointID slider = carriage(3);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.force = 10;
    dJointSetDrive(slider, 0, &drive);
    settle();
    EXPECT_NEAR(double(dJointGetDriveForce(slider, 0)), 10, tol(1e-9, 1e-4));
    EXPECT_NEAR(force(slider), 3 * kG - 10, tol(1e-6, 1e-3));
}

// q_0 + 2 q_1 >= kBeyond: with m_0 = 1 and m_1 = 2 kg both carriages are borne by one force, f = g and 2 f = 2 g.
TEST_P(StopForces, of_couplings_act_along_their_sum)
{
    const dJointID one = carriage(1), two = carriage(2), sum = dJointCreateCoupling(sim.world, nullptr);
    for (const dJointID slider : {one, two}) dJointSetSliderParam(slider, dParamLoStop, real(-100));
    dJointSetCouplingAxis(sum, 0, one, 0, 1), dJointSetCouplingAxis(sum, 1, two, 0, 2);
    dJointSetCouplingParam(sum, dParamHiStop, 1), dJointSetCouplingParam(sum, dParamLoStop, real(kBeyond));
    settle();
    EXPECT_NEAR(force(sum), kG, tol(1e-6, 1e-3));
    EXPECT_NEAR(double(dJointGetCouplingForce(sum)), force(sum), tol(1e-7, 1e-3));
}

TEST(StopForcesRefuse, axes_without_stops)
{
    const Messages messages;
    Sim sim;
    const dJointID ball = dJointCreateBall(sim.world, nullptr);
    EXPECT_EQ(dJointGetStopForce(ball, 0), 0);
    EXPECT_EQ(messages.count(), 1);
    EXPECT_EQ(dJointGetStopForce(nullptr, 0), 0);
}

}  // namespace
}  // namespace epode::physics
