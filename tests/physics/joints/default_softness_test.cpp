// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What joints yield under a load F in steps of h: J v = 0 = ERP/h error - CFM F, so error = CFM F h/ERP. The default
// CFM is literal up to h/2000 times the inverse mass, or about an axis the inverse inertia; beyond, the yield no
// longer grows with the mass: it is that of h/2000 of the velocity which the load gives in a step. Every other CFM
// is literal for whatever mass.
#include "rig.h"

namespace epode::physics::default_softness {
namespace {

constexpr double kDefault = tol(1e-10, 1e-5), kUnit = tol(1.0 / 2000, 2e-6), kErp = 0.2;
constexpr double kLightest = 1e-3, kHeaviest = 1e10;

class DefaultSoftness : public testing::TestWithParam<Stepper> {};

// Hangs in its centre at the origin; returns how deep it has sunk.
double sinking(Stepper stepper, double mass, double h, double g, double cfm)
{
    Sim sim(stepper);
    if (cfm > 0) dWorldSetCFM(sim.world, real(cfm));
    sim.gravity(0, 0, -g);
    const dBodyID body = sim.body({}, mass, mass);
    const dJointID joint = dJointCreateBall(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetBallAnchor(joint, 0, 0, 0);
    for (int i = 0; i < 300; ++i) EXPECT_EQ(sim.advance(h), 1);
    return -position(body).z;
}

// The same about an axis: a torque across the axis of a hinge.
double turning(Stepper stepper, double inertia, double h, double torque)
{
    Sim sim(stepper);
    const dBodyID body = sim.body({}, 1, inertia);
    const dJointID joint = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetHingeAnchor(joint, 0, 0, 0);
    dJointSetHingeAxis(joint, 0, 0, 1);
    for (int i = 0; i < 300; ++i) {
        dBodyAddTorque(body, real(torque), 0, 0);
        EXPECT_EQ(sim.advance(h), 1);
    }
    return 2 * double(dBodyGetQuaternion(body)[1]);
}

TEST_P(DefaultSoftness, yields_with_the_load_and_no_further_than_a_share_of_what_the_load_moves)
{
    constexpr double g = 100;
    for (const double h : {1.0 / 60, 0.001})
        for (double m = kLightest; m <= kHeaviest; m *= 10) {
            const double cfm = std::min(kDefault, kUnit * h / m);
            const double expected = cfm * m * g * h / kErp;
            EXPECT_NEAR(sinking(GetParam(), m, h, g, 0), expected, 1e-3 * expected) << m << " kg, h = " << h;
        }
}

TEST_P(DefaultSoftness, about_an_axis_it_follows_the_inertia)
{
    for (double inertia = kLightest; inertia <= kHeaviest; inertia *= 10) {
        constexpr double h = 0.01, acceleration = 10;
        const double torque = inertia * acceleration;
        const double expected = std::min(kDefault, kUnit * h / inertia) * torque * h / kErp;
        EXPECT_NEAR(turning(GetParam(), inertia, h, torque), expected, 2e-3 * expected)
            << inertia << " kg m^2";
    }
}

TEST_P(DefaultSoftness, every_other_cfm_is_literal)
{
    constexpr double h = 0.01, g = 10, limited_from = kUnit * h / kDefault;
    for (const double times : {0.5, 1.5, 20.0})
        for (const double masses : {0.01, 1.0, 100.0}) {
            const double m = masses * limited_from;
            const double expected = times * kDefault * m * g * h / kErp;
            EXPECT_NEAR(sinking(GetParam(), m, h, g, times * kDefault), expected, 1e-3 * expected)
                << m << " kg, CFM " << times << " times the default";
        }
}

INSTANTIATE_TEST_SUITE_P(Steppers, DefaultSoftness, testing::Values(Stepper::kExact, Stepper::kQuick),
                         [](const auto& chosen) { return name_of(chosen.param); });

TEST(DefaultSoftnessOfOde, is_literal)
{
    const double h = 0.01, m = 100 * kUnit * h / kDefault;
    Sim sim;
    dWorldSetBehaviour(sim.world, dBehaviour016);
    sim.gravity(0, 0, -10);
    const dBodyID body = sim.body({}, m, m);
    const dJointID joint = dJointCreateBall(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetBallAnchor(joint, 0, 0, 0);
    for (int i = 0; i < 300; ++i) ASSERT_EQ(sim.advance(h), 1);
    const double expected = kDefault * m * 10 * h / kErp;
    EXPECT_NEAR(-position(body).z, expected, 1e-3 * expected);
}

}  // namespace
}  // namespace epode::physics::default_softness
