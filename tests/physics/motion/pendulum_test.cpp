// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A physical pendulum released at theta0 swings with T = 4 K(sin(theta0/2)) sqrt(I/(m g l)), I about the
// pivot; K(k) = pi / (2 agm(1, sqrt(1 - k^2))) (Gauss). The steppers are of first order: the error of the
// period shrinks with the step. Small angles: two pendulums of one length but different inertia differ as
// they must.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

double quarter_elliptic(double k)
{
    double a = 1, b = std::sqrt(1 - k * k);
    for (int i = 0; i < 20; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return kPi / (2 * a);
}

struct Swing {
    double theta0 = 1, arm = 1, mass = 1, inertia = 1, g = 9.81;

    double period() const
    {
        return 4 * quarter_elliptic(std::sin(theta0 / 2)) *
               std::sqrt((inertia + mass * arm * arm) / (mass * g * arm));
    }
};

// Time between the first and the third passage of the lowest point, found by linear interpolation.
double measured_period(Stepper stepper, const Swing& swing, double h)
{
    Sim sim(stepper);
    sim.substeps = 4;
    dWorldSetQuickStepNumIterations(sim.world, 50);
    sim.gravity(0, 0, -swing.g);
    const V3 start{swing.arm * std::sin(swing.theta0), 0, -swing.arm * std::cos(swing.theta0)};
    dBodyID b = sim.body(start, swing.mass, swing.inertia);
    dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, b, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    double first = 0, before = swing.theta0;
    int passages = 0;
    for (int i = 1; i * h < 3 * swing.period(); ++i) {
        sim.advance(h);
        const V3 p = position(b);
        const double now = std::atan2(p.x, -p.z);
        if ((now < 0) != (before < 0)) {
            const double when = (i - 1) * h + h * before / (before - now);
            if (++passages == 1) first = when;
            if (passages == 3) return when - first;
        }
        before = now;
    }
    return 0;
}

struct Pendulum : testing::TestWithParam<Stepper> {};

TEST_P(Pendulum, swings_with_the_period_of_the_elliptic_integral)
{
    for (double theta0 : {0.2, 1.0, 2.0}) {
        Swing swing;
        swing.theta0 = theta0;
        const double exact = swing.period();
        const double coarse = std::fabs(measured_period(GetParam(), swing, 0.02) - exact);
        const double fine = std::fabs(measured_period(GetParam(), swing, 0.0025) - exact);
        EXPECT_LT(fine, 0.004 * exact) << theta0;
        // An eighth of the step: at least a third of the error is gone, unless it was rounding already.
        EXPECT_LT(fine, 0.6 * coarse + tol(2e-4, 2e-3) * exact) << theta0;
    }
}

TEST_P(Pendulum, knows_inertia_from_mass)
{
    Swing light;
    light.theta0 = 0.3;
    light.inertia = 0.05;
    Swing heavy = light;
    heavy.mass = 5;
    heavy.inertia = 20;
    for (const Swing& swing : {light, heavy})
        EXPECT_NEAR(measured_period(GetParam(), swing, 0.002), swing.period(), 0.004 * swing.period());
}

TEST_P(Pendulum, hangs_at_the_distance_it_was_hung)
{
    Sim sim(GetParam());
    sim.gravity(0, 0, -9.81);
    dBodyID b = sim.body({1, 0, 0});
    dJointID ball = dJointCreateBall(sim.world, nullptr);
    dJointAttach(ball, b, nullptr);
    dJointSetBallAnchor(ball, 0, 0, 0);
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
        sim.advance(0.01);
        dVector3 a;
        dJointGetBallAnchor(ball, a);
        worst = std::max(worst, length(vec(a)));
    }
    // Per step the anchor leaves its circle by h^2 w^2 / 2 with w^2 <= 10, and ERP 0.2 brings a fifth back.
    EXPECT_LT(worst, 5 * 0.5 * 0.01 * 0.01 * 10);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Pendulum, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
