// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A capsule of 45 g between two pads, held by friction alone. Hard contact does not creep: a friction row
// yields by CFM times its force, here CFM m g / 4, and by nothing else, whatever the load and the time step.
// Soft and relaxed contact models lose micrometres to millimetres a second in this test.
#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kRadius = 0.004, kMass = 0.045, kFriction = 0.7;

struct Grip {
    Sim sim;
    dBodyID capsule, held, pushed;

    Grip()
    {
        const V3 pad{0.01, 0.03, 0.03};
        const double reach = kRadius + pad.x / 2 - 1e-6;  // a little in, so that they touch from the start
        sim.gravity(0, 0, -kG);
        sim.surface.mode = dContactApprox1;
        sim.surface.mu = real(kFriction);
        capsule = sim.capsule({0, 0, 0}, kRadius, 0.06, kMass);
        held = sim.box({-reach, 0, 0}, pad, 0.1);
        pushed = sim.box({reach, 0, 0}, pad, 0.1);
        dJointID motor = slide(held);
        dJointSetSliderParam(motor, dParamVel, 0);
        dJointSetSliderParam(motor, dParamFMax, real(1e4));
        slide(pushed);
    }

    dJointID slide(dBodyID body)
    {
        dJointID joint = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(joint, body, nullptr);
        dJointSetSliderAxis(joint, 1, 0, 0);
        return joint;
    }

    void hold(double seconds, double h, double load)
    {
        for (int i = 0; i < int(std::lround(seconds / h)); ++i) {
            dBodyAddForce(pushed, real(-load), 0, 0);
            sim.step(h);
        }
    }

    // Past the pads' faces, which are across x.
    V3 slip() const
    {
        const V3 d = position(capsule) - 0.5 * (position(held) + position(pushed));
        return {0, d.y, d.z};
    }
};

struct Grasp : testing::TestWithParam<double> {};

TEST_P(Grasp, a_held_capsule_does_not_creep)
{
    const double h = GetParam(), seconds = 9;
    for (double load : {12.0, 30.0, 60.0}) {
        Grip grip;
        const Messages messages;
        grip.hold(1, h, load);
        const V3 before = grip.slip();
        grip.hold(seconds, h, load);
        EXPECT_LT(length(grip.slip() - before) / seconds, tol(1e-9, 1e-5)) << "load " << load;
        EXPECT_EQ(messages.count(), 0);
    }
}

TEST_P(Grasp, a_capsule_that_friction_cannot_hold_falls_with_what_is_left_of_gravity)
{
    const double h = GetParam(), seconds = 0.05;
    const double load = 0.25 * kMass * kG / (2 * kFriction);  // friction carries a quarter of the weight
    Grip grip;
    grip.hold(seconds, h, load);
    const double time = h * double(std::lround(seconds / h));
    EXPECT_NEAR(velocity(grip.capsule).z, -0.75 * kG * time, 0.02 * kG * time);
}

INSTANTIATE_TEST_SUITE_P(Steps, Grasp, testing::Values(0.001, 0.01, 1.0 / 60));

}  // namespace
}  // namespace epode::physics
