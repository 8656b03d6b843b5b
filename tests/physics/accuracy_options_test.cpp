// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetExactRotation. What a rigid body keeps must be kept: a free top its energy and momentum, a heavy
// top its energy and its precession, whose rate for a fast one is m g l / (I3 s) (1 + m g l It cos / (I3 s)^2
// ...), taken here from a run with a sixteenth of the step. And what the client has asked for otherwise
// stays.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

// ---- exact rotation ----

dBodyID top(Sim& sim, double i1, double i2, double i3)
{
    dBodyID b = sim.body({0, 0, 0});
    dMass m;
    dMassSetParameters(&m, 1, 0, 0, 0, real(i1), real(i2), real(i3), 0, 0, 0);
    dBodySetMass(b, &m);
    return b;
}

struct Drift {
    double energy = 0, length = 0, direction = 0;  // worst, relative
};

Drift fly(Stepper stepper, double h, double seconds, V3 w, bool exact)
{
    Sim sim(stepper);
    dWorldSetExactRotation(sim.world, exact);
    dBodyID b = top(sim, 1, 2, 2.8);
    velocity(b, {}, w);
    const V3 L0 = spin_momentum(b);
    const double E0 = kinetic_energy(b);
    Drift worst;
    for (int i = 0, n = int(seconds / h + 0.5); i < n; ++i) {
        sim.advance(h);
        const V3 L = spin_momentum(b);
        worst.energy = std::max(worst.energy, std::fabs(kinetic_energy(b) / E0 - 1));
        worst.length = std::max(worst.length, std::fabs(length(L) / length(L0) - 1));
        worst.direction = std::max(worst.direction, length(L - L0) / length(L0));
    }
    return worst;
}

// About the middle axis, where tumbling is wildest.
TEST(ExactRotation, a_free_body_keeps_energy_and_angular_momentum_for_100_s)
{
    for (Stepper stepper : {Stepper::kExact, Stepper::kQuick})
        for (double speed : {1.0, 5.0, 60.0}) {
            const Drift d = fly(stepper, 1 / 60., 100, {0.01 * speed, speed, 0.02 * speed}, true);
            EXPECT_LT(d.energy, tol(1e-11, 1e-3)) << name_of(stepper) << " at " << speed;
            EXPECT_LT(d.length, tol(1e-11, 1e-3)) << name_of(stepper) << " at " << speed;
            EXPECT_LT(d.direction, tol(1e-11, 1e-2)) << name_of(stepper) << " at " << speed;
        }
    EXPECT_GT(fly(Stepper::kExact, 1 / 60., 100, {0.01, 1, 0.02}, false).energy, 0.05)
        << "the original's rule damps: else this test proves nothing";
}

// Radians per step: the turn is no longer meaningful, but nothing blows up and energy stays.
TEST(ExactRotation, an_absurd_spin_keeps_its_energy)
{
    for (double speed : {150.0, 1000.0, 3000.0}) {
        const Drift d = fly(Stepper::kExact, 1 / 60., 10, {0.01 * speed, speed, 0.02 * speed}, true);
        EXPECT_LT(d.energy, tol(1e-10, 1e-2)) << speed;
        EXPECT_LT(d.length, tol(1e-10, 1e-2)) << speed;
    }
}

// The free motion converges with the second order of h: the attitude after a second.
TEST(ExactRotation, the_attitude_is_of_second_order)
{
    const auto attitude = [](double h) {
        Sim sim;
        dWorldSetExactRotation(sim.world, 1);
        dBodyID b = top(sim, 1, 2, 2.8);
        velocity(b, {}, {0.4, 2, 0.7});
        for (int i = 0, n = int(1 / h + 0.5); i < n; ++i) sim.advance(h);
        const dReal* q = dBodyGetQuaternion(b);
        return std::vector<double>{q[0], q[1], q[2], q[3]};
    };
    const auto exact = attitude(1 / 4096.), fine = attitude(1 / 128.), coarse = attitude(1 / 32.);
    double e_fine = 0, e_coarse = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        e_fine = std::max(e_fine, std::fabs(fine[i] - exact[i]));
        e_coarse = std::max(e_coarse, std::fabs(coarse[i] - exact[i]));
    }
    EXPECT_LT(e_coarse, 0.01);
    if constexpr (!kSingle) { EXPECT_NEAR(e_coarse / e_fine, 16, 1.5); }
}

TEST(ExactRotation, a_torque_gives_the_momentum_that_it_should)
{
    Sim sim;
    dWorldSetExactRotation(sim.world, 1);
    dBodyID b = top(sim, 1, 2, 2.8);
    velocity(b, {}, {1, 2, -1});
    V3 L = spin_momentum(b);
    for (int i = 0; i < 200; ++i) {
        const V3 t{std::sin(0.1 * i), 0.5, std::cos(0.07 * i)};
        dBodyAddTorque(b, real(t.x), real(t.y), real(t.z));
        sim.advance(0.01);
        L = L + 0.01 * t;
        EXPECT_LT(length(spin_momentum(b) - L), tol(1e-12, 1e-4)) << i;
    }
}

// A top on a ball joint at its tip, h = 1/60: what it loses, how fast it precesses.
struct HeavyTop {
    double lost = 0, precession = 0;
};

HeavyTop spin_heavy_top(double h, bool exact)
{
    Sim sim;
    sim.gravity(0, 0, -9.81);
    dWorldSetExactRotation(sim.world, exact);
    dBodyID b = top(sim, 0.02, 0.02, 0.01);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0, 0, 0.5);
    dBodySetRotation(b, R);
    const V3 axis{0, -std::sin(0.5), std::cos(0.5)};
    place(b, 0.1 * axis);
    velocity(b, {}, 40.0 * axis);
    dJointID j = dJointCreateBall(sim.world, nullptr);
    dJointAttach(j, b, nullptr);
    dJointSetBallAnchor(j, 0, 0, 0);
    const double E0 = energy(sim), seconds = 10;
    const auto azimuth = [b] { return std::atan2(dBodyGetRotation(b)[6], dBodyGetRotation(b)[2]); };
    double angle = 0, last = azimuth();
    for (int i = 0, n = int(seconds / h + 0.5); i < n; ++i) {
        sim.advance(h);
        angle += std::remainder(azimuth() - last, 2 * kPi);
        last = azimuth();
    }
    return {(E0 - energy(sim)) / E0, angle / seconds};
}

TEST(ExactRotation, a_heavy_top_keeps_precessing)
{
    const HeavyTop coarse = spin_heavy_top(1 / 60., true), fine = spin_heavy_top(1 / 960., true);
    EXPECT_LT(std::fabs(coarse.lost), 0.03);
    EXPECT_NEAR(coarse.precession, fine.precession, 0.05 * fine.precession);
    EXPECT_NEAR(fine.precession, 0.981 / 0.4, 0.25 * 0.981 / 0.4) << "the fast top's rate, first order";
    EXPECT_GT(spin_heavy_top(1 / 60., false).lost, 0.5) << "the original's rule brings it down";
}

// A joint holds the axis of an unbalanced wheel: the spin stays, and what is read satisfies the joint.
TEST(ExactRotation, a_hinge_holds_an_unbalanced_wheel)
{
    Sim sim;
    dWorldSetExactRotation(sim.world, 1);
    dBodyID b = top(sim, 1, 2, 2.8);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 1, 0, 0.6);
    dBodySetRotation(b, R);
    dJointID j = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(j, b, nullptr);
    dJointSetHingeAnchor(j, 0, 0, 0);
    dJointSetHingeAxis(j, 0, 0, 1);
    velocity(b, {}, {0, 0, 10});
    double settled = 0, angle = 0;
    for (int i = 0; i < 6000; ++i) {
        if (i == 100) settled = spin(b).z, angle = dJointGetHingeAngle(j);
        sim.advance(1 / 60.);
        ASSERT_LT(std::hypot(spin(b).x, spin(b).y), tol(1e-6, 1e-2)) << i;
    }
    // The first steps divide the momentum between what is seen and what is carried over: order (w h)^2.
    EXPECT_NEAR(settled, 10, 10 * (10 / 60.) * (10 / 60.) / 8);
    EXPECT_NEAR(spin(b).z, settled, tol(1e-6, 1e-2));
    const double off = dJointGetHingeAngle(j) - angle - 5900 * settled / 60;
    EXPECT_NEAR(std::remainder(off, 2 * kPi), 0, tol(1e-4, 0.5));
}

TEST(ExactRotation, respects_what_the_body_was_told)
{
    Sim sim;
    dWorldSetExactRotation(sim.world, 1);
    dBodyID dull = top(sim, 1, 2, 2.8), capped = top(sim, 1, 2, 2.8), kinematic = top(sim, 1, 2, 2.8);
    dBodySetGyroscopicMode(dull, 0);
    dBodySetMaxAngularSpeed(capped, 2);
    dBodySetKinematic(kinematic);
    for (dBodyID b : {dull, capped, kinematic}) velocity(b, {}, {1, 3, -2});
    for (int i = 0; i < 100; ++i) {
        sim.advance(0.01);
        EXPECT_LE(length(spin(capped)), 2 * (1 + 4 * kEpsilon));
    }
    for (dBodyID b : {dull, kinematic}) {
        EXPECT_EQ(length(spin(b) - V3{1, 3, -2}), 0);
        const dReal* q = dBodyGetQuaternion(b);
        EXPECT_NEAR(std::fabs(q[0]), std::fabs(std::cos(std::sqrt(14.) / 2)), 400 * kEpsilon);
    }
}

// What a body has left over from constraints does not survive a velocity that the client sets, nor the mode.
TEST(ExactRotation, nothing_is_left_over_from_the_past)
{
    Sim used, fresh;
    for (Sim* sim : {&used, &fresh}) dWorldSetExactRotation(sim->world, 1);
    dBodyID a = top(used, 1, 2, 2.8), b = top(fresh, 1, 2, 2.8);
    dJointID j = dJointCreateBall(used.world, nullptr);
    dJointAttach(j, a, nullptr);
    dJointSetBallAnchor(j, 1, 0, 0);
    velocity(a, {}, {3, 2, 1});
    for (int i = 0; i < 20; ++i) used.advance(0.01);
    dJointDestroy(j);
    const dQuaternion unit = {1, 0, 0, 0};
    dBodySetQuaternion(a, unit);
    for (dBodyID each : {a, b}) velocity(each, {}, {1, 2, 3}), place(each, {0, 0, 0});
    for (int i = 0; i < 20; ++i) used.advance(0.01), fresh.advance(0.01);
    EXPECT_EQ(hash_state(used), hash_state(fresh));
}

TEST(AccuracyOptions, refuse_values_that_mean_nothing)
{
    Sim sim;
    Messages messages;
    dWorldSetExactRotation(sim.world, 1);
    for (int bad : {-1, 2}) dWorldSetExactRotation(sim.world, bad);
    EXPECT_EQ(messages.count(), 2);
    EXPECT_EQ(dWorldGetExactRotation(sim.world), 1);
    dWorldSetExactRotation(nullptr, 1);
    EXPECT_EQ(dWorldGetExactRotation(nullptr), 0);
    EXPECT_EQ(messages.count(), 4);
}

}  // namespace
}  // namespace epode::physics
