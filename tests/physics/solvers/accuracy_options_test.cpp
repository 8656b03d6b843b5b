// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The options of ode/ext.h that make dWorldStep more accurate.
// dWorldSetExactRotation: what a rigid body keeps must be kept: a free top its energy and momentum, a heavy
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

enum class Turns { kByDefault, kByOption, kAsOde };

Drift fly(Stepper stepper, double h, double seconds, V3 w, Turns turns = Turns::kByDefault)
{
    Sim sim(stepper);
    dWorldSetExactRotation(sim.world, turns == Turns::kByOption);
    if (turns == Turns::kAsOde) dWorldSetBehaviour(sim.world, dBehaviour016);
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
    for (Stepper stepper : kSteppers)
        for (double speed : {1.0, 5.0, 60.0}) {
            const Drift d = fly(stepper, 1 / 60., 100, {0.01 * speed, speed, 0.02 * speed});
            EXPECT_LT(d.energy, tol(1e-11, 1e-3)) << name_of(stepper) << " at " << speed;
            EXPECT_LT(d.length, tol(1e-11, 1e-3)) << name_of(stepper) << " at " << speed;
            EXPECT_LT(d.direction, tol(1e-11, 1e-2)) << name_of(stepper) << " at " << speed;
        }
    EXPECT_GT(fly(Stepper::kExact, 1 / 60., 100, {0.01, 1, 0.02}, Turns::kAsOde).energy, 0.05)
        << "the original's rule damps: else this test proves nothing";
}

// Radians per step: the turn is no longer meaningful, but nothing blows up and energy stays.
TEST(ExactRotation, an_absurd_spin_keeps_its_energy)
{
    for (double speed : {150.0, 1000.0, 3000.0}) {
        const Drift d =
            fly(Stepper::kExact, 1 / 60., 10, {0.01 * speed, speed, 0.02 * speed}, Turns::kByOption);
        EXPECT_LT(d.energy, tol(1e-10, 0.3)) << speed;
        EXPECT_LT(d.length, tol(1e-10, 0.15)) << speed;
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

using OneStep = int (*)(dWorldID, dReal);

HeavyTop spin_heavy_top(double h, bool exact, OneStep step = dWorldStep)
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
        step(sim.world, real(h));
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

int in_four_substeps(dWorldID world, dReal h) { return dWorldStepFast1(world, h, 4); }

// In substeps it is nearer still: errors of joints are those of a quarter of the step.
TEST(ExactRotation, a_heavy_top_keeps_precessing_in_every_stepper)
{
    const double rate = spin_heavy_top(1 / 960., true).precession;
    for (const OneStep step :
         {OneStep(dWorldQuickStep), OneStep(dWorldStepHybrid), OneStep(in_four_substeps)}) {
        const HeavyTop coarse = spin_heavy_top(1 / 60., true, step);
        EXPECT_LT(std::fabs(coarse.lost), 0.03);
        EXPECT_NEAR(coarse.precession, rate, 0.05 * rate);
        EXPECT_GT(spin_heavy_top(1 / 60., false, step).lost, 0.5);
    }
}

// A plate spins about a joint at its centre, lets go, and is caught again: what its velocity does not show of the momentum goes with it, but
// for the part that a reading in the middle of a substep leaves out.
TEST(ExactRotation, the_momentum_goes_from_joints_into_the_air_and_back)
{
    Sim sim;
    dWorldUseDefaults(sim.world, dDefaultsGame);
    dWorldSetAutoDisableFlag(sim.world, 0);
    const dBodyID plate = top(sim, 1, 2, 2.8);
    velocity(plate, {}, {3, 4, 5});
    const V3 L = spin_momentum(plate);
    const dJointID ball = dJointCreateBall(sim.world, nullptr);
    for (int phase = 0; phase < 4; ++phase) {
        dJointAttach(ball, phase % 2 ? plate : nullptr, nullptr);
        if (phase % 2) dJointSetBallAnchor(ball, 0, 0, 0);
        for (int i = 0; i < 50; ++i) ASSERT_EQ(in_four_substeps(sim.world, real(1 / 60.)), 1);
        EXPECT_LT(length(spin_momentum(plate) - L), 0.03 * length(L)) << phase;
    }
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
    EXPECT_NEAR(spin(b).z, settled, tol(1e-6, 0.15));
    if (kSingle) return;  // such a change of spin adds up to radians
    const double off = dJointGetHingeAngle(j) - angle - 5900 * settled / 60;
    EXPECT_NEAR(std::remainder(off, 2 * kPi), 0, 1e-4);
}

TEST(ExactRotation, respects_the_settings_of_the_body)
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

// ---- projection ----

dJointID ball(Sim& sim, dBodyID a, dBodyID b, V3 at)
{
    dJointID j = dJointCreateBall(sim.world, nullptr);
    dJointAttach(j, a, b);
    dJointSetBallAnchor(j, real(at.x), real(at.y), real(at.z));
    return j;
}

dJointID hinge(Sim& sim, dBodyID a, dBodyID b, V3 at, V3 axis = {0, 1, 0})
{
    dJointID j = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(j, a, b);
    dJointSetHingeAnchor(j, real(at.x), real(at.y), real(at.z));
    dJointSetHingeAxis(j, real(axis.x), real(axis.y), real(axis.z));
    return j;
}

// Distance between the two ends of the joint, of hinges and balls.
double gap(dJointID j)
{
    dVector3 a, b;
    if (dJointGetType(j) == dJointTypeBall) {
        dJointGetBallAnchor(j, a);
        dJointGetBallAnchor2(j, b);
    } else {
        dJointGetHingeAnchor(j, a);
        dJointGetHingeAnchor2(j, b);
    }
    return length(vec(a) - vec(b));
}

struct Projection : testing::Test {
    Sim sim;
    Messages messages;
    std::vector<dJointID> joints;
    double worst = 0;
    int open = 0;

    Projection()
    {
        sim.gravity(0, 0, -9.81);
        dWorldSetStepProjection(sim.world, 8);
        dWorldSetStepReportMode(sim.world, 1);
    }
    void run(double seconds, double h, bool contacts = false)
    {
        for (int i = 0, n = int(seconds / h + 0.5); i < n; ++i) {
            ASSERT_EQ(contacts ? sim.step(h) : sim.advance(h), 1);
            for (dJointID j : joints) worst = std::max(worst, gap(j));
            open += sim.report().projections_unconverged;
        }
        EXPECT_TRUE(finite_state(sim));
        EXPECT_EQ(messages.count(), 0) << messages.last();
    }
};

// 32 links of 1 kg and 0.25 m let go horizontally, the last one heavier; plain dWorldStep opens such joints
// by links (3.6 of them for equal masses at 1/60).
struct WhippedChain : testing::TestWithParam<double> {};

TEST_P(WhippedChain, stays_closed_at_every_mass_ratio)
{
    // Rows and poses of seven digits: what holds the end is lost next to its weight.
    if (kSingle && GetParam() > 1000) GTEST_SKIP() << "single precision holds mass ratios up to 1000";
    constexpr int kLinks = 32;
    constexpr double kLink = 0.25;
    for (double h : {1 / 60., 1 / 100.}) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldSetStepProjection(sim.world, 8);
        std::vector<dJointID> joints;
        for (int i = 0; i < kLinks; ++i) {
            dBodyID b = dBodyCreate(sim.world);
            dMass m;
            dMassSetCapsuleTotal(&m, 1, 1, real(0.05), real(0.15));
            if (i == kLinks - 1) dMassSetSphereTotal(&m, real(GetParam()), real(0.1 * std::cbrt(GetParam())));
            dBodySetMass(b, &m);
            place(b, {(i + 0.5) * kLink, 0, 0});
            joints.push_back(ball(sim, b, i ? sim.bodies.back() : nullptr, {i * kLink, 0, 0}));
            sim.bodies.push_back(b);
        }
        const double E0 = energy(sim), fall = GetParam() * 9.81 * kLinks * kLink;
        double worst = 0, rise = 0;
        for (int i = 0, n = int(10 / h + 0.5); i < n; ++i) {
            sim.advance(h);
            for (dJointID j : joints) worst = std::max(worst, gap(j));
            rise = std::max(rise, (energy(sim) - E0) / fall);
        }
        EXPECT_LT(worst, 0.01 * kLink) << "1/h = " << 1 / h;
        EXPECT_LT(rise, tol(1e-3, 1e-2)) << "1/h = " << 1 / h;
        EXPECT_TRUE(finite_state(sim));
    }
}

INSTANTIATE_TEST_SUITE_P(Ratios, WhippedChain, testing::Values(1., 10., 100., 1e4, 1e6));

V3 velocity_at(dBodyID body, V3 point)
{
    dVector3 v;
    dBodyGetRelPointVel(body, dReal(point.x), dReal(point.y), dReal(point.z), v);
    return {v[0], v[1], v[2]};
}

// The impulses of the step close the joints (step/island/positions/shake.h), and its velocities are those that they allow there.
TEST_F(Projection, ends_with_closed_joints_and_velocities_that_they_allow)
{
    dBodyID a = sim.body({0.5, 0, 0}), b = sim.body({1.5, 0, 0});
    joints = {ball(sim, a, nullptr, {0, 0, 0}), ball(sim, b, a, {1, 0, 0})};
    velocity(a, {0, 0, 2}, {0, -4, 0}), velocity(b, {0, 0, 6}, {0, -4, 0});
    for (int i = 0; i < 20; ++i) {
        run(0.01, 0.01);
        // In floats, two positions within 1.5 m and two arms of 0.5 m, each turned by products of three numbers, are rounded by
        // 7 kEpsilon where a joint is closed, and again where it is measured.
        EXPECT_LT(worst, tol(1e-6, 14 * kEpsilon)) << i;
        const V3 speeds[2] = {velocity_at(a, {-0.5, 0, 0}),
                              velocity_at(a, {0.5, 0, 0}) - velocity_at(b, {-0.5, 0, 0})};
        for (const V3& apart : speeds)
            EXPECT_LT(length(apart), tol(1e-8, 1e-5)) << i;  // what CFM lets them give
    }
}

// A parallelogram of bars on hinges, three rows too many, driven through its dead points.
TEST_F(Projection, a_redundant_four_bar_goes_through_its_dead_points)
{
    dBodyID crank = sim.box({0, 0, 0.25}, {0.05, 0.05, 0.5}, 1);
    dBodyID coupler = sim.box({0.5, 0, 0.5}, {1, 0.05, 0.05}, 2);
    dBodyID rocker = sim.box({1, 0, 0.25}, {0.05, 0.05, 0.5}, 1);
    joints = {hinge(sim, crank, nullptr, {0, 0, 0}), hinge(sim, coupler, crank, {0, 0, 0.5}),
              hinge(sim, rocker, coupler, {1, 0, 0.5}), hinge(sim, nullptr, rocker, {1, 0, 0})};
    dJointSetHingeParam(joints[0], dParamVel, 6);
    dJointSetHingeParam(joints[0], dParamFMax, 200);
    run(10, 1 / 60.);
    EXPECT_LT(worst, 1e-3);
    EXPECT_EQ(open, 0);
    EXPECT_NEAR(std::fabs(dJointGetHingeAngleRate(joints[0])), 6, 0.5);
}

// A square mesh of bars on ball joints: many loops.
TEST_F(Projection, a_net_of_loops_stays_closed)
{
    constexpr int kSide = 4;
    std::vector<dBodyID> nodes;
    for (int i = 0; i < kSide * kSide; ++i)
        nodes.push_back(sim.sphere({double(i % kSide), double(i / kSide), 0}, 0.1, i ? 1 : 30));
    const auto bar = [&](int i, int k) {
        const V3 a = position(nodes[i]), b = position(nodes[k]), d = b - a;
        dBodyID rod = sim.box(0.5 * (a + b), {0.1 + std::fabs(d.x), 0.1 + std::fabs(d.y), 0.1}, 0.5);
        joints.push_back(ball(sim, rod, nodes[i], a));
        joints.push_back(ball(sim, rod, nodes[k], b));
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (x + 1 < kSide) bar(y * kSide + x, y * kSide + x + 1);
            if (y + 1 < kSide) bar(y * kSide + x, (y + 1) * kSide + x);
        }
    joints.push_back(ball(sim, nodes[kSide - 1], nullptr, position(nodes[kSide - 1])));
    joints.push_back(ball(sim, nodes[kSide * (kSide - 1)], nullptr, position(nodes[kSide * (kSide - 1)])));
    run(5, 1 / 60.);
    EXPECT_LT(worst, 0.01);
}

// A body of length 1 pinned at both ends to points 1.5 apart: nothing can close this.
TEST_F(Projection, joints_that_contradict_each_other_do_no_harm)
{
    dBodyID bar = sim.box({0, 0, 0}, {1, 0.1, 0.1}, 1);
    joints = {ball(sim, bar, nullptr, {-0.5, 0, 0}), ball(sim, bar, nullptr, {0.5, 0, 0})};
    dJointSetBallAnchor2(joints[0], real(-0.75), 0, 0);
    dJointSetBallAnchor2(joints[1], real(0.75), 0, 0);
    run(5, 1 / 60.);
    EXPECT_GT(open, 200) << "and it says so";
    EXPECT_NEAR(worst, 0.25, 0.02) << "the error is shared";
    EXPECT_LT(length(position(bar)), 0.05);
    EXPECT_LT(length(velocity(bar)), 0.1);
    EXPECT_LT(length(spin(bar)), 0.1);
}

TEST_F(Projection, a_sunken_stack_is_lifted_without_a_jump)
{
    sim.surface.mu = 1;
    sim.ground();
    for (int i = 0; i < 5; ++i) sim.box({0, 0, 0.45 + 0.9 * i}, {1, 1, 1}, 1);
    run(1 / 60., 1 / 60., true);
    // Depths of 0.05 on the ground and 0.1 between boxes lose a fifth.
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(position(sim.bodies[i]).z, 0.46 + 0.92 * double(i), 1e-3) << i;
    for (dBodyID b : sim.bodies) EXPECT_LT(length(velocity(b)), tol(1e-6, 1e-3));
    run(3, 1 / 60., true);
    for (std::size_t i = 0; i < 5; ++i) {
        // Each contact keeps one and a half tolerances of 0.87 m.
        EXPECT_NEAR(position(sim.bodies[i]).z, 0.5 + double(i), 1.4 * double(i + 1) * tol(1e-4, 1e-3)) << i;
        EXPECT_LT(length(velocity(sim.bodies[i])), 1e-3) << i;
        EXPECT_GE(sim.contact_count, 20) << "contacts are still found";
    }
}

// A pile of boxes that falls and comes to rest: it must, and must not gain energy on the way.
TEST_F(Projection, a_pile_comes_to_rest)
{
    Random random(3);
    sim.surface.mu = real(0.6);
    sim.ground();
    for (int i = 0; i < 27; ++i) {
        const V3 at{0.8 * (i % 3) + random.uniform(0, 0.1), 0.8 * (i / 3 % 3) + random.uniform(0, 0.1),
                    1 + 0.9 * (i / 9)};
        sim.box(at, {random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), random.uniform(0.3, 0.7)}, 1);
    }
    double before = energy(sim);
    for (int i = 0; i < 300; ++i) {
        run(1 / 60., 1 / 60., true);
        ASSERT_LT(energy(sim), before + 1) << i;
        before = energy(sim);
    }
    for (dBodyID b : sim.bodies) EXPECT_LT(length(velocity(b)), 0.02);
}

TEST_F(Projection, a_contact_that_opens_is_not_pulled_back)
{
    sim.gravity(0, 0, 0);
    sim.ground();
    dBodyID b = sim.sphere({0, 0, 0.49}, 0.5, 1);
    velocity(b, {0, 0, 3});
    run(0.01, 0.01, true);
    EXPECT_NEAR(position(b).z, 0.49 + 0.03, 100 * kEpsilon);
    EXPECT_EQ(sim.report().projection_iterations, 0);
}

TEST_F(Projection, a_stop_is_not_overrun)
{
    dBodyID b = sim.box({0.5, 0, 0}, {1, 0.1, 0.1}, 1);
    joints = {hinge(sim, b, nullptr, {0, 0, 0})};
    dJointSetHingeParam(joints[0], dParamLoStop, real(-0.5));
    dJointSetHingeParam(joints[0], dParamHiStop, real(0.5));
    double beyond = 0;
    for (int i = 0; i < 300; ++i) {
        const double before = std::fabs(dJointGetHingeAngle(joints[0]));
        run(1 / 60., 1 / 60.);
        // A stop acts from the first step that begins beyond it.
        if (before > 0.5) beyond = std::max(beyond, std::fabs(dJointGetHingeAngle(joints[0])) - 0.5);
    }
    EXPECT_LT(beyond, tol(1.1e-4, 1.1e-3));
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(std::fabs(dJointGetHingeAngle(joints[0])), 0.5, 1e-3);
}

// lo = hi with stop ERP and CFM is a spring: it must sag, and swing, as it does without the projection.
TEST_F(Projection, springs_are_left_alone)
{
    Sim plain;
    plain.gravity(0, 0, -9.81);
    double z[2];
    for (int k = 0; k < 2; ++k) {
        Sim& s = k ? plain : sim;
        dBodyID b = s.body({0, 0, 0});
        dJointID j = dJointCreateSlider(s.world, nullptr);
        dJointAttach(j, b, nullptr);
        dJointSetSliderAxis(j, 0, 0, 1);
        const double h = 0.01, stiff = 100, damp = 1;
        dJointSetSliderParam(j, dParamLoStop, 0);
        dJointSetSliderParam(j, dParamHiStop, 0);
        dJointSetSliderParam(j, dParamStopERP, real(h * stiff / (h * stiff + damp)));
        dJointSetSliderParam(j, dParamStopCFM, real(1 / (h * stiff + damp)));
        for (int i = 0; i < 77; ++i) s.advance(h);
        z[k] = position(b).z;
    }
    EXPECT_LT(z[0], -0.05);
    EXPECT_NEAR(z[0], z[1], tol(1e-9, 1e-5));
}

// A client that sets an angular motor's angles by hand, once: they do not tell where the body is.
TEST_F(Projection, angles_that_do_not_follow_the_pose_turn_nothing_away)
{
    sim.gravity(0, 0, 0);
    dBodyID b = sim.body({0, 0, 0});
    dJointID j = dJointCreateAMotor(sim.world, nullptr);
    dJointAttach(j, b, nullptr);
    dJointSetAMotorNumAxes(j, 1);
    dJointSetAMotorAxis(j, 0, 0, 0, 0, 1);
    dJointSetAMotorParam(j, dParamHiStop, 0);
    dJointSetAMotorParam(j, dParamLoStop, -dInfinity);
    dJointSetAMotorAngle(j, 0, real(0.1));
    run(0.01, 0.01);
    EXPECT_NEAR(2 * std::asin(dBodyGetQuaternion(b)[3]), -0.1, 1e-3) << "once, by what was told";
}

TEST_F(Projection, all_joint_types_are_closed)
{
    dBodyID base = sim.box({0, 0, 0}, {1, 1, 0.2}, 50);
    dBodySetGravityMode(base, 0);
    dJointID j[5] = {dJointCreateHinge2(sim.world, nullptr), dJointCreateUniversal(sim.world, nullptr),
                     dJointCreateSlider(sim.world, nullptr), dJointCreateFixed(sim.world, nullptr),
                     dJointCreateHinge(sim.world, nullptr)};
    for (int i = 0; i < 5; ++i) {
        dBodyID b = sim.box({0.8 * std::cos(1.2 * i), 0.8 * std::sin(1.2 * i), -0.3}, {0.2, 0.3, 0.5}, 1);
        dJointAttach(j[i], base, b);
        velocity(b, {0, 0, 0}, {1.0 * i, 3, 2});
    }
    dJointSetHinge2Anchor(j[0], real(0.8), 0, 0);
    const dReal up[3] = {0, 0, 1}, across[3] = {0, 1, 0};
    dJointSetHinge2Axes(j[0], up, across);
    const V3 u = position(sim.bodies[2]), h = position(sim.bodies[5]);
    dJointSetUniversalAnchor(j[1], real(u.x), real(u.y), 0);
    dJointSetUniversalAxis1(j[1], 1, 0, 0);
    dJointSetUniversalAxis2(j[1], 0, 1, 0);
    dJointSetSliderAxis(j[2], 0, 1, 0);
    dJointSetFixed(j[3]);
    dJointSetHingeAnchor(j[4], real(h.x), real(h.y), 0);
    dJointSetHingeAxis(j[4], 1, 1, 0);
    velocity(base, {0, 0, 0}, {0.5, 1, 2});
    run(5, 1 / 60.);
    EXPECT_EQ(open, 0);
    EXPECT_GT(sim.report().joint_error + sim.report().joint_angle_error, 0);
    EXPECT_LT(sim.report().joint_error, tol(1.1e-4, 4e-3));
    EXPECT_LT(sim.report().joint_angle_error, tol(1.1e-4, 1.1e-3));
}

// ---- sub-steps ----

// Joints without ERP and CFM have nothing that depends on h: n parts are n steps. (Forces of the program are a kick in the first part.)
TEST(ExactSubsteps, are_as_many_steps)
{
    for (bool exact_rotation : {false, true}) {
        Sim parts, steps;
        constexpr int n = 4;
        for (Sim* s : {&parts, &steps}) {
            s->gravity(1, 2, -9.81);
            dWorldSetERP(s->world, 0);
            dWorldSetCFM(s->world, 0);
            dWorldSetExactRotation(s->world, exact_rotation);
            for (int i = 0; i < 3; ++i) {
                dBodyID b = s->box({0.5 + i, 0, 0}, {1, 0.2, 0.1}, 1 + i);
                hinge(*s, b, i ? s->bodies[std::size_t(i - 1)] : nullptr, {double(i), 0, 0}, {0.1 * i, 1, 0});
            }
            velocity(s->box({0, 5, 0}, {1, 2, 3}, 1), {1, 2, 3}, {1, 2, 3});
        }
        dWorldSetExactSubsteps(parts.world, n);
        for (int i = 0; i < 50; ++i) {
            parts.advance(0.0625);
            for (int k = 0; k < n; ++k) steps.advance(0.0625 / n);
        }
        EXPECT_EQ(hash_state(parts), hash_state(steps)) << exact_rotation;
    }
}

// m v' = -k z - d v - m g by implicit Euler with h/n; the pair of ERP and CFM is that of h.
TEST(ExactSubsteps, a_spring_stays_the_same_spring)
{
    const double h = 0.05, stiff = 100, damp = 1, g = 9.81;
    for (int n : {1, 3, 10}) {
        Sim sim;
        sim.gravity(0, 0, -g);
        dWorldSetExactSubsteps(sim.world, n);
        dBodyID b = sim.body({0, 0, 0});
        dJointID j = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(j, b, nullptr);
        dJointSetSliderAxis(j, 0, 0, 1);
        dJointSetSliderParam(j, dParamLoStop, 0);
        dJointSetSliderParam(j, dParamHiStop, 0);
        dJointSetSliderParam(j, dParamStopERP, real(h * stiff / (h * stiff + damp)));
        dJointSetSliderParam(j, dParamStopCFM, real(1 / (h * stiff + damp)));
        double z = 0, v = 0;
        const double hs = h / n;
        for (int i = 0; i < 60; ++i) {
            sim.advance(h);
            for (int k = 0; k < n; ++k) {
                v = (v - hs * (g + stiff * z)) / (1 + hs * damp + hs * hs * stiff);
                z += hs * v;
            }
            ASSERT_NEAR(position(b).z, z, tol(1e-9, 1e-4)) << n << " parts, step " << i;
        }
    }
}

TEST(ExactSubsteps, feedback_is_the_mean_force)
{
    Sim sim;
    sim.gravity(0, 0, -10);
    dWorldSetExactSubsteps(sim.world, 5);
    dBodyID b = sim.body({1, 0, 0}, 3, 1);
    dJointID j = ball(sim, b, nullptr, {0, 0, 0});
    dJointFeedback f;
    dJointSetFeedback(j, &f);
    // Swinging: the impulse of the joint is what momentum lacks.
    for (int i = 0; i < 30; ++i) {
        const V3 before = velocity(b);
        dBodyAddForce(b, 1, 0, 2);
        sim.advance(0.02);
        const V3 lacks = 3.0 * (velocity(b) - before) - 0.02 * V3{1, 0, 2 - 30};
        EXPECT_LT(length(0.02 * vec(f.f1) - lacks), tol(1e-12, 1e-4)) << i;
    }
}

TEST(ExactSubsteps, bring_a_pendulum_nearer_to_its_motion)
{
    const auto angle_after = [](int parts, double h) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldSetExactSubsteps(sim.world, parts);
        dBodyID b = sim.box({0.5, 0, 0}, {1, 0.1, 0.1}, 1);
        dJointID j = hinge(sim, b, nullptr, {0, 0, 0});
        for (int i = 0, n = int(2 / h + 0.5); i < n; ++i) sim.advance(h);
        return double(dJointGetHingeAngle(j));
    };
    const double exact = angle_after(1, 1 / 8192.);
    const double one = std::fabs(angle_after(1, 1 / 64.) - exact),
                 four = std::fabs(angle_after(4, 1 / 64.) - exact),
                 sixteen = std::fabs(angle_after(16, 1 / 64.) - exact);
    EXPECT_LT(four, 0.4 * one);
    EXPECT_LT(sixteen, 0.4 * four + tol(1e-6, 1e-3));
}

TEST(ExactSubsteps, a_ball_bounces_once_at_the_beginning)
{
    const double h = 0.02, e = 0.8;
    for (int n : {1, 4}) {
        Sim sim;
        sim.gravity(0, 0, -10);
        dWorldSetCFM(sim.world, 0);  // in single precision the default gives by millimetres
        dWorldSetExactSubsteps(sim.world, n);
        sim.ground();
        sim.surface.mode |= dContactBounce;
        sim.surface.bounce = real(e);
        sim.surface.bounce_vel = real(0.1);
        dBodyID b = sim.sphere({0, 0, 0.4999}, 0.5, 1);
        velocity(b, {0, 0, -3});
        sim.step(h);
        EXPECT_NEAR(velocity(b).z, e * 3 - 10 * h * (n - 1) / n, tol(1e-6, 1e-4)) << n;
        double top = 0;
        for (int i = 0; i < 1000; ++i) sim.step(h), top = std::max(top, position(b).z);
        EXPECT_LT(top, 0.5 + e * e * 9 / 20 + 0.03) << n;
        EXPECT_NEAR(position(b).z, 0.5, 0.02) << n;
    }
}

// Thrown up from the ground so gently that it is back within the step.
TEST(ExactSubsteps, a_contact_that_opens_closes_again_and_no_further)
{
    Sim sim;
    sim.gravity(0, 0, -20);
    dWorldSetCFM(sim.world, 0);
    dWorldSetExactSubsteps(sim.world, 20);
    sim.ground();
    dBodyID b = sim.sphere({0, 0, 0.5}, 0.5, 1);
    velocity(b, {1, 0, 0.5});
    sim.step(0.1);
    ASSERT_GT(sim.contact_count, 0);
    EXPECT_NEAR(position(b).z, 0.5, tol(1e-6, 1e-5));
    // In floats the height of half a metre is rounded by a quarter of kEpsilon in each of 20 substeps of 5 ms, the last of which closes
    // what that has opened.
    EXPECT_NEAR(velocity(b).z, 0, tol(1e-6, 20 * (kEpsilon / 4) / 0.005));
}

TEST(ExactSubsteps, a_stack_rests_and_its_momentum_is_what_forces_gave)
{
    Sim sim;
    sim.gravity(0, 0, -9.81);
    dWorldSetExactSubsteps(sim.world, 4);
    dWorldSetStepReportMode(sim.world, 1);
    sim.surface.mu = real(0.6);
    sim.ground();
    for (int i = 0; i < 5; ++i) sim.box({0, 0, 0.5 + i}, {1, 1, 1}, 1);
    for (int i = 0; i < 120; ++i) {
        sim.step(1 / 60.);
        ASSERT_LT(sim.report().residual, tol(1e-9, 1e-4));
    }
    for (int i = 0; i < 5; ++i) {
        EXPECT_NEAR(position(sim.bodies[std::size_t(i)]).z, 0.5 + i, 2e-3);
        EXPECT_LT(length(velocity(sim.bodies[std::size_t(i)])), 1e-3);
    }
    // Two boxes that collide in the air keep their momentum and its moment.
    Sim air;
    dWorldSetExactSubsteps(air.world, 5);
    air.surface.mu = real(0.5);
    velocity(air.box({0, 0, 0}, {1, 1, 1}, 1), {1, 0, 0}, {0, 0, 0.5});
    velocity(air.box({0.99, 0.3, 0.2}, {1, 1, 1}, 2), {-1, 0.2, 0}, {0.3, 0, 0});
    const V3 P = momentum(air), L = angular_momentum(air);
    air.step(1 / 60.);
    ASSERT_GT(air.contact_count, 0);
    EXPECT_LT(length(momentum(air) - P), tol(1e-12, 1e-5));
    EXPECT_LT(length(angular_momentum(air) - L), tol(1e-3, 1e-3));
}

TEST(ExactSubsteps, a_stop_acts_within_the_step)
{
    double beyond[2];
    for (int k = 0; k < 2; ++k) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldSetExactSubsteps(sim.world, k ? 8 : 1);
        dBodyID b = sim.box({0.5, 0, 0}, {1, 0.1, 0.1}, 1);
        dJointID j = hinge(sim, b, nullptr, {0, 0, 0});
        dJointSetHingeParam(j, dParamLoStop, real(-0.5));
        dJointSetHingeParam(j, dParamHiStop, real(0.5));
        dJointSetHingeParam(j, dParamBounce, real(0.5));
        beyond[k] = 0;
        for (int i = 0; i < 60; ++i) {
            sim.advance(1 / 30.);
            beyond[k] = std::max(beyond[k], std::fabs(dJointGetHingeAngle(j)) - 0.5);
        }
    }
    EXPECT_GT(beyond[0], 0.01);
    EXPECT_LT(beyond[1], 0.3 * beyond[0]);
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

TEST(AccuracyOptions, of_steps_refuse_values_that_mean_nothing)
{
    Sim sim;
    Messages messages;
    const dWorldID w = sim.world;
    EXPECT_EQ(dWorldGetStepProjection(w), 0);
    EXPECT_NEAR(dWorldGetStepProjectionTolerance(w), tol(1e-4, 1e-3), 1e-9);
    dWorldSetStepProjection(w, 3);
    dWorldSetStepProjectionTolerance(w, real(1e-5));
    EXPECT_EQ(dWorldGetExactSubsteps(w), 1);
    dWorldSetExactSubsteps(w, 7);
    for (int bad : {0, -1, 1001}) dWorldSetExactSubsteps(w, bad);
    EXPECT_EQ(dWorldGetExactSubsteps(w), 7);
    EXPECT_EQ(messages.count(), 3);
    messages.clear();
    for (int bad : {-1, 101}) dWorldSetStepProjection(w, bad);
    for (double bad : {0.0, -1.0, 1.0, std::nan(""), double(dInfinity)})
        dWorldSetStepProjectionTolerance(w, real(bad));
    EXPECT_EQ(messages.count(), 7);
    EXPECT_EQ(dWorldGetStepProjection(w), 3);
    EXPECT_EQ(dWorldGetStepProjectionTolerance(w), real(1e-5));
}

}  // namespace
}  // namespace epode::physics
