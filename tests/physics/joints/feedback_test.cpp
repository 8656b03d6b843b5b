// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Feedback is the mean force over a step, in every way to step: with gravity it explains the change of each
// body's momentum, m (v' - v) = h (m g + f), and of its angular momentum about its centre, I'w' - I w = h t.
// Axes lean by 45 degrees, where a joint's choice of two directions perpendicular to its axis is undecided and
// may change from substep to substep.
#include "drive_ways.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kH = 0.01;

struct Momenta {
    V3 linear, angular;
};

Momenta momenta_of(dBodyID body)
{
    dMass mass;
    dBodyGetMass(body, &mass);
    return {double(mass.mass) * velocity(body), spin_momentum(body)};
}

struct Feedback : testing::TestWithParam<Way> {
    Feedback() { sim.gravity(0, 0, -kG); }

    dBodyID rod(V3 at)
    {
        const dBodyID body = sim.body(at);
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, real(0.04), real(0.1), real(0.1), 0, 0, 0);
        dBodySetMass(body, &mass);
        return body;
    }

    // Steps, and returns by how much the feedback misses the momenta of these bodies at worst, N and N m.
    Momenta worst_miss(dJointID joint, std::initializer_list<dBodyID> bodies, double seconds)
    {
        dJointFeedback feedback{};
        dJointSetFeedback(joint, &feedback);
        Momenta worst;
        for (int i = 0; i < int(seconds / kH); ++i) {
            Momenta before[2], *from = before;
            for (dBodyID body : bodies) *from++ = momenta_of(body);
            epode::physics::step(sim, GetParam(), kH);
            from = before;
            for (dBodyID body : bodies) {
                const bool first = from == before;
                const Momenta now = momenta_of(body);
                dMass mass;
                dBodyGetMass(body, &mass);
                const V3 force = (1 / kH) * (now.linear - from->linear) - V3{0, 0, -kG * double(mass.mass)};
                const V3 torque = (1 / kH) * (now.angular - from->angular);
                const V3 missing_force = force - vec(first ? feedback.f1 : feedback.f2);
                const V3 missing_torque = torque - vec(first ? feedback.t1 : feedback.t2);
                worst.linear.x = std::max(worst.linear.x, length(missing_force));
                worst.angular.x = std::max(worst.angular.x, length(missing_torque));
                ++from;
            }
        }
        dJointSetFeedback(joint, nullptr);
        return worst;
    }

    void expect_explained(dJointID joint, std::initializer_list<dBodyID> bodies)
    {
        const Momenta miss = worst_miss(joint, bodies, 2);
        EXPECT_LT(miss.linear.x, tol(1e-8, 2e-2));
        EXPECT_LT(miss.angular.x, tol(1e-5, 5e-2));
    }

    Sim sim;
};
INSTANTIATE_TEST_SUITE_P(Ways, Feedback, testing::ValuesIn(kWays), way_name);

TEST_P(Feedback, of_a_ball_joint_explains_motion)
{
    const dBodyID body = rod({2, 0, 0});
    const dJointID joint = dJointCreateBall(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetBallAnchor(joint, 0, 0, 0);
    expect_explained(joint, {body});
}

TEST_P(Feedback, of_a_hinge_explains_motion)
{
    const dBodyID body = rod({2, 0, 0});
    const dJointID joint = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetHingeAnchor(joint, 0, 0, 0);
    dJointSetHingeAxis(joint, 0, 1, 1);
    expect_explained(joint, {body});
}

TEST_P(Feedback, of_a_piston_explains_motion)
{
    const dBodyID body = rod({2, 0, 0});
    const dJointID joint = dJointCreatePiston(sim.world, nullptr);
    dJointAttach(joint, body, nullptr);
    dJointSetPistonAnchor(joint, 0, 0, 0);
    dJointSetPistonAxis(joint, 0, real(std::sin(kPi / 4)), real(std::cos(kPi / 4)));
    expect_explained(joint, {body});
}

TEST_P(Feedback, of_two_bodies_explains_the_motion_of_both)
{
    const dBodyID a = rod({0, 0, 0}), b = sim.body({2, 0, 0}, 2);
    velocity(a, {0, 1, 0}), velocity(b, {0, -1, 1}, {1, 0, 0});
    const dJointID joint = dJointCreateSlider(sim.world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetSliderAxis(joint, 0, real(std::sin(kPi / 4)), real(std::cos(kPi / 4)));
    const Momenta miss = worst_miss(joint, {a, b}, 2);
    EXPECT_LT(miss.linear.x, tol(1e-8, 2e-2));
}

// Of contact joints, while a ball hits another one off its centre, spinning, and rebounds.
TEST_P(Feedback, of_contacts_explains_the_motion_of_both)
{
    const dBodyID a = sim.body({0, 0, 1}, 1, 0.4), b = sim.body({0.3, 0, -1}, 2, 0.8);
    sim.gravity(0, 0, 0);
    velocity(a, {0, 0, -2}, {0, 3, 0}), velocity(b, {0, 0, 1});
    double largest = 0;
    for (int i = 0; i < 100; ++i) {
        const V3 between = position(a) - position(b), n = (1 / length(between)) * between;
        dContact contact = make_contact(position(b) + n, n, 2 - length(between));
        contact.surface.mode = dContactBounce, contact.surface.bounce = real(0.5);
        contact.surface.mu = real(0.5);
        const bool touches = length(between) < 2;
        dJointFeedback feedback{};
        if (touches) {
            const dJointID joint = dJointCreateContact(sim.world, sim.contacts, &contact);
            dJointAttach(joint, a, b);
            dJointSetFeedback(joint, &feedback);
        }
        const Momenta before[2] = {momenta_of(a), momenta_of(b)};
        epode::physics::step(sim, GetParam(), kH);
        const Momenta after[2] = {momenta_of(a), momenta_of(b)};
        const dReal* reported[2][2] = {{feedback.f1, feedback.t1}, {feedback.f2, feedback.t2}};
        for (int k = 0; k < 2; ++k) {
            const V3 force = (1 / kH) * (after[k].linear - before[k].linear) - vec(reported[k][0]);
            const V3 torque = (1 / kH) * (after[k].angular - before[k].angular) - vec(reported[k][1]);
            EXPECT_LT(length(force), tol(1e-9, 1e-2)) << "body " << k << ", step " << i;
            EXPECT_LT(length(torque), tol(1e-9, 1e-2)) << "body " << k << ", step " << i;
        }
        largest = std::max(largest, length(vec(feedback.f1)));
        dJointGroupEmpty(sim.contacts);
    }
    EXPECT_GT(largest, 100);
}

// A pendulum let go level pulls with three times the weight across its axis at the lowest point. Its joint
// breaks with a limit below that, and holds with one above it.
TEST_P(Feedback, breaks_joints_at_the_forces_that_act)
{
    const double largest = 3 * kG * std::sqrt(0.5);
    for (const double limit : {0.9 * largest, 1.1 * largest}) {
        Sim other;
        other.gravity(0, 0, -kG);
        const dBodyID body = other.body({2, 0, 0}, 1, 0.01);
        const dJointID joint = dJointCreatePiston(other.world, nullptr);
        dJointAttach(joint, body, nullptr);
        dJointSetPistonAnchor(joint, 0, 0, 0);
        dJointSetPistonAxis(joint, 0, real(std::sin(kPi / 4)), real(std::cos(kPi / 4)));
        dJointSetBreakLimits(joint, real(limit), 0);
        epode::physics::step(other, GetParam(), kH, 300);
        EXPECT_EQ(dJointIsBroken(joint), limit < largest ? 1 : 0) << limit;
    }
}

}  // namespace
}  // namespace epode::physics
