// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints that the projection closes keep the energy of what swings and tumbles on them, and exert what feedback
// says. (Velocities that stayed as they were lost 30 % in 20 s of a pendulum with steps of 5 ms.) In floats the
// tolerance of the projection is larger, so it corrects few of these steps.
#include <algorithm>
#include <cmath>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kH = 0.005, kLink = 0.5;

struct Swing : testing::Test {
    void TestBody() override {}
    Sim sim;
    dJointID hook = nullptr;

    Swing()
    {
        dWorldUseDefaults(sim.world, dDefaultsRobot);
        sim.gravity(0, 0, -9.81);
    }
    // Bars in a row, the first one hung up, the last one of mass `load`.
    void chain(int links, double load)
    {
        for (int i = 0; i < links; ++i) {
            const dBodyID bar =
                sim.box({(i + 0.5) * kLink, 0, 0}, {kLink, 0.05, 0.05}, i + 1 < links ? 1 : load);
            const dJointID joint = dJointCreateBall(sim.world, nullptr);
            dJointAttach(joint, bar, i ? sim.bodies[std::size_t(i) - 1] : nullptr);
            dJointSetBallAnchor(joint, real(i * kLink), 0, 0);
            if (i == 0) hook = joint;
        }
        for (const dBodyID b : sim.bodies) dGeomDestroy(dBodyGetFirstGeom(b));
    }
    void tree(std::uint32_t seed)
    {
        Random random(seed);
        for (int i = 0; i < 6; ++i) {
            const int parent = i ? int(random.uniform(0, i)) : -1;
            V3 way = random.point(1);
            way = (1 / length(way)) * way;
            const V3 from = i ? position(sim.bodies[std::size_t(parent)]) : V3{}, at = i ? from + way : from;
            const dBodyID body = sim.body(at, random.uniform(0.5, 2), 0.1);
            velocity(body, random.point(1), random.point(3));
            if (i) join(body, sim.bodies[std::size_t(parent)], from + 0.5 * way, i % 3, random.point(1));
        }
    }
    void join(dBodyID a, dBodyID b, V3 at, int type, V3 axis)
    {
        const dJointID joint = type == 0   ? dJointCreateBall(sim.world, nullptr)
                               : type == 1 ? dJointCreateHinge(sim.world, nullptr)
                                           : dJointCreateUniversal(sim.world, nullptr);
        dJointAttach(joint, a, b);
        const dReal x = real(at.x), y = real(at.y), z = real(at.z);
        const dReal u = real(axis.x), v = real(axis.y), w = real(axis.z);
        if (type == 0) dJointSetBallAnchor(joint, x, y, z);
        if (type == 1) dJointSetHingeAnchor(joint, x, y, z), dJointSetHingeAxis(joint, u, v, w);
        if (type != 2) return;
        dJointSetUniversalAnchor(joint, x, y, z);
        const V3 other = cross(axis, {0.3, 0.5, 0.8});
        dJointSetUniversalAxis1(joint, u, v, w);
        dJointSetUniversalAxis2(joint, real(other.x), real(other.y), real(other.z));
    }
    // Above the lowest place.
    double height_and_motion() const
    {
        double lowest = 0, depth = 0;
        for (const dBodyID b : sim.bodies) {
            dMass m;
            dBodyGetMass(b, &m);
            depth += kLink, lowest -= double(m.mass) * 9.81 * (depth - kLink / 2);
        }
        return energy(sim) - lowest;
    }
};

TEST_F(Swing, a_pendulum_keeps_its_energy)
{
    chain(1, 1);
    const double start = height_and_motion();
    for (int i = 0; i < 4000; ++i) {
        sim.advance(kH);
        ASSERT_NEAR(height_and_motion(), start, tol(0.015, 0.25) * start) << "after " << i * kH << " s";
    }
}

TEST_F(Swing, a_double_pendulum_keeps_its_energy)
{
    chain(2, 1);
    const double start = height_and_motion();
    double largest = start;
    for (int i = 0; i < 2000; ++i) sim.advance(kH), largest = std::max(largest, height_and_motion());
    EXPECT_GT(height_and_motion(), tol(0.96, 0.75) * start);  // 0.47 before
    EXPECT_LT(largest, 1.01 * start);
}

// The rotor of a drive has its share of the energy, and its drive exerts nothing. (With 0.02 kg m^2 half of the
// energy was lost.)
TEST(Swings, with_rotors_keep_their_energy)
{
    for (const double armature : {0.02, 0.1, 1.0}) {
        Swing swing;
        const dBodyID bar = swing.sim.body({kLink / 2, 0, 0}, 1, 0.02);
        const dJointID hinge = dJointCreateHinge(swing.sim.world, nullptr);
        dJointAttach(hinge, bar, nullptr);
        dJointSetHingeAnchor(hinge, 0, 0, 0);
        dJointSetHingeAxis(hinge, 0, 1, 0);
        dDrive drive;
        dDriveInit(&drive, sizeof drive);
        drive.armature = real(armature);
        ASSERT_EQ(dJointSetDrive(hinge, 0, &drive), 1);
        const auto whole = [&] {
            const double rate = double(dJointGetHingeAngleRate(hinge));
            return swing.height_and_motion() + armature * rate * rate / 2;
        };
        const double start = whole();
        double force = 0;
        for (int i = 0; i < 4000; ++i) {
            swing.sim.advance(kH);
            ASSERT_NEAR(whole(), start, tol(0.03, 0.3) * start) << armature << " after " << i * kH << " s";
            force = std::max(force, std::abs(double(dJointGetDriveForce(hinge, 0))));
        }
        EXPECT_LT(force, tol(1e-9, 0.05)) << armature;
    }
}

// Where SHAKE alone explodes: heavy loads on light links, and steps that are long for them. A symplectic step has an energy that swings
// about the true one, by the share w h of what changes within 1/w: no second may have more in the mean than there was, and a whip's
// crack stays near it.
TEST(Swings, of_loads_gain_nothing)
{
    for (const double load : {1.0, 10.0, 100.0, 1000.0})
        for (const int links : {2, 5, 10})
            for (const double h : {0.001, kH, 1.0 / 60}) {
                Swing swing;
                swing.chain(links, load);
                const double start = swing.height_and_motion();
                const int second = int(1 / h);
                double largest = start, mean = 0;
                for (int i = 1; i <= 6 * second; ++i) {
                    swing.sim.advance(h);
                    const double now = swing.height_and_motion();
                    largest = std::max(largest, now), mean += now / second;
                    if (i % second) continue;
                    EXPECT_LT(mean, 1.01 * start) << links << " links, load " << load << ", h = " << h;
                    mean = 0;
                }
                EXPECT_LT(largest, (1.05 + 8 * h) * start)
                    << links << " links, load " << load << ", h = " << h;
            }
}

// In steps that are short for a chain its energy does not drift either, and the shorter they are, the less it swings.
TEST(Swings, of_chains_are_kept)
{
    for (const int links : {2, 5, 10}) {
        double before = HUGE_VAL;
        for (const double h : {0.0025, 0.00125, 0.000625}) {
            Swing swing;
            swing.chain(links, 1);
            const double start = swing.height_and_motion();
            double worst = 0;
            for (int i = 0; i < int(10 / h); ++i)
                swing.sim.advance(h),
                    worst = std::max(worst, std::fabs(swing.height_and_motion() / start - 1));
            EXPECT_LT(worst, tol(0.06, 0.3)) << links << " links, h = " << h;
            EXPECT_LT(worst, tol(1, 3) * before) << links << " links, h = " << h;
            before = worst;
            EXPECT_NEAR(swing.height_and_motion(), start, tol(0.03, 0.3) * start)
                << links << " links, h = " << h;
        }
    }
}

// A tree of bodies on joints of three types, without gravity.
TEST_F(Swing, what_tumbles_keeps_energy_and_angular_momentum)
{
    sim.gravity(0, 0, 0);
    double energy_lost = 0, momentum_lost = 0;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        Swing own;
        own.sim.gravity(0, 0, 0);
        own.tree(seed);
        own.sim.advance(kH);
        const V3 L = angular_momentum(own.sim);
        const double start = energy(own.sim);
        for (int i = 0; i < 1000; ++i) own.sim.advance(kH);
        EXPECT_LT(energy(own.sim), 1.001 * start) << seed;
        energy_lost += (1 - energy(own.sim) / start) / 10;
        momentum_lost += length(angular_momentum(own.sim) - L) / length(L) / 10;
    }
    EXPECT_LT(energy_lost, 0.01);
    EXPECT_LT(momentum_lost, 0.01);
}

// The force of the hook, weight and the change of momentum agree in every step, though the projection has
// turned velocities.
TEST_F(Swing, joints_exert_what_feedback_says)
{
    chain(3, 1);
    dJointFeedback feedback{};
    dJointSetFeedback(hook, &feedback);
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        V3 before, after;
        for (const dBodyID b : sim.bodies) before = before + velocity(b);
        sim.advance(kH);
        for (const dBodyID b : sim.bodies) after = after + velocity(b);
        worst = std::max(worst, length(after - before - kH * (vec(feedback.f1) + V3{0, 0, -3 * 9.81})));
    }
    EXPECT_LT(worst, tol(1e-12, 1e-4));
}

// Where a step ends the velocities are those that joints allow there, and not those of its beginning turned on by w h / 2.
TEST_F(Swing, joints_hold_velocities_where_the_step_ends)
{
    chain(3, 1);
    double worst = 0, fastest = 0;
    for (int i = 0; i < 400; ++i) {
        sim.advance(kH);
        dVector3 anchor, gap;
        dJointGetBallAnchor(hook, anchor);
        dBodyGetPointVel(sim.bodies[0], anchor[0], anchor[1], anchor[2], gap);
        worst = std::max(worst, length(vec(gap)));
        fastest = std::max(fastest, length(velocity(sim.bodies[2])));
    }
    EXPECT_GT(fastest, 3);
    EXPECT_LT(worst, tol(1e-4, 0.02));
}

}  // namespace
}  // namespace epode::physics
