// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Drives on joint axes against closed forms: the implicit recurrence of a spring, a damper, a rotor, dry
// friction and a limited servo, free and at a stop, in every way to step; and the motion of the continuous
// law, to which they converge at first order.
#include <functional>

#include "drive_ways.h"

namespace epode::physics {
namespace {

constexpr double kStep = 0.01;
// Relative to rates of about 1 m/s; sweeps in floats and dozens of steps pile up rounding.
constexpr double kClose = tol(1e-9, 2e-4);

struct Case {
    const char* name;
    std::function<void(DrivenAxis&)> set;
};

std::vector<Case> cases()
{
    return {
        {"spring", [](DrivenAxis& a) { a.drive.stiffness = 300; }},
        {"stiff spring", [](DrivenAxis& a) { a.drive.stiffness = 1e8, a.drive.target = real(0.1); }},
        {"damper", [](DrivenAxis& a) { a.drive.damping = 5, a.drive.target_velocity = real(0.5); }},
        {"given force", [](DrivenAxis& a) { a.drive.force = 3; }},
        {"limited force", [](DrivenAxis& a) { a.drive.force = 30, a.drive.force_limit = 2; }},
        {"rotor", [](DrivenAxis& a) { a.drive.armature = 7, a.other_force = 2; }},
        {"rotor and force", [](DrivenAxis& a) { a.drive.armature = 7, a.drive.force = -3; }},
        {"friction slides", [](DrivenAxis& a) { a.drive.friction = 2, a.other_force = 5; }},
        {"friction sticks", [](DrivenAxis& a) { a.drive.friction = 9, a.other_force = 5; }},
        {"servo",
         [](DrivenAxis& a) {
             a.drive.stiffness = 200, a.drive.damping = 20, a.drive.armature = 2, a.drive.target = 1;
         }},
        {"limited servo",
         [](DrivenAxis& a) {
             a.drive.stiffness = 2000, a.drive.damping = 50, a.drive.target = 1, a.drive.force_limit = 10;
         }},
        {"limited servo with rotor and friction",
         [](DrivenAxis& a) {
             a.drive.stiffness = 2000, a.drive.damping = 50, a.drive.target = 1, a.drive.force_limit = 10;
             a.drive.armature = 3, a.drive.friction = 1;
         }},
    };
}

struct Drive : testing::TestWithParam<Way> {
    static void calm(Sim& sim)
    {
        dWorldSetQuickStepW(sim.world,
                            1);  // one axis: the sweep is exact, over-relaxation goes back and forth
        dWorldSetCFM(sim.world, 0);
    }

    static dJointID slider(Sim& sim, dBodyID a, dBodyID b)
    {
        dJointID joint = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetSliderAxis(joint, 1, 0, 0);
        return joint;
    }

    // Steps a body on a slider and the scalar law together.
    void follows(const DrivenAxis& axis, const char* name, double q, double w)
    {
        Sim sim;
        calm(sim);
        dBodyID b = sim.body({0, 0, 0}, axis.mass);
        dJointID joint = slider(sim, b, nullptr);
        place(b, {q, 0, 0});
        velocity(b, {w, 0, 0});
        ASSERT_EQ(dJointSetDrive(joint, 0, &axis.drive), 1);
        if (axis.high < HUGE_VAL) dJointSetSliderParam(joint, dParamHiStop, real(axis.high));
        const int parts = parts_of(GetParam());
        sim.gravity(axis.other_force / axis.mass, 0,
                    0);  // a program's force is a kick, where it moves something
        for (int i = 0; i < 60; ++i) {
            step(sim, GetParam(), kStep);
            double force = 0;
            for (int k = 0; k < parts; ++k) {
                const double h = kStep / parts, next = axis.next_rate(q, w, h);
                force += axis.pull(q, next, h) / parts;
                q += h * next, w = next;
            }
            ASSERT_NEAR(double(dJointGetAxisRate(joint, 0)), w, kClose) << name << ", step " << i;
            ASSERT_NEAR(double(dJointGetAxisPosition(joint, 0)), q, kClose) << name << ", step " << i;
            const double stiff = std::max(1.0, double(axis.drive.stiffness)) * kClose;
            ASSERT_NEAR(double(dJointGetDriveForce(joint, 0)), force, std::max(stiff, 1e4 * kClose))
                << name << ", step " << i;
        }
    }
};

TEST_P(Drive, follows_the_implicit_law)
{
    for (const Case& c : cases()) {
        DrivenAxis axis;
        axis.mass = 2;
        c.set(axis);
        follows(axis, c.name, 0.3, -0.7);
    }
}

// The stop's row is the drive's neighbour, not in its place. With substeps a stop is hard and bounce-free
// too, but it is corrected in another way: see below.
TEST_P(Drive, follows_the_implicit_law_at_a_stop)
{
    if (parts_of(GetParam()) > 1) GTEST_SKIP() << "stops of substeps are corrected and relaxed";
    for (const Case& c : cases()) {
        // Sweeps need many steps until friction lets the stop take the last depth out.
        if (GetParam() == Way::kQuick && std::string(c.name).find("friction") != std::string::npos) continue;
        DrivenAxis axis;
        axis.mass = 2, axis.high = 0.2137;
        c.set(axis);
        axis.other_force += 4;
        follows(axis, c.name, 0.1, 0.7);
    }
}

TEST_P(Drive, rests_at_a_stop_and_leaves_it)
{
    Sim sim;
    calm(sim);
    dBodyID b = sim.body({0, 0, 0}, 2);
    dJointID joint = slider(sim, b, nullptr);
    dJointSetSliderParam(joint, dParamHiStop, real(0.5));
    dDrive drive = no_drive();
    drive.stiffness = 100, drive.damping = 20, drive.armature = 5, drive.target = 1;
    dJointSetDrive(joint, 0, &drive);
    step(sim, GetParam(), kStep, 600);
    EXPECT_NEAR(double(dJointGetAxisPosition(joint, 0)), 0.5, 1e-3);
    EXPECT_NEAR(double(dJointGetDriveForce(joint, 0)), 50, 0.2);
    drive.target = 0;
    dJointSetDrive(joint, 0, &drive);
    step(sim, GetParam(), kStep, 2000);
    EXPECT_NEAR(double(dJointGetAxisPosition(joint, 0)), 0, 1e-3);
}

// Two bodies, neither held: the axis has their reduced mass, and their sum of momenta stays.
TEST_P(Drive, acts_between_two_free_bodies)
{
    Sim sim;
    calm(sim);
    dWorldSetQuickStepNumIterations(sim.world, 60);
    DrivenAxis axis;
    axis.mass = 1 / (1 / 2.0 + 1 / 3.0);
    axis.drive.stiffness = 400, axis.drive.damping = 4, axis.drive.armature = 3,
    axis.drive.target = real(0.4);
    dBodyID a = sim.body({0, 0, 0}, 2), b = sim.body({-1, 0, 0}, 3);
    dJointID joint = slider(sim, a, b);
    velocity(a, {1, 0.5, 0});
    velocity(b, {-1, 0.5, 0});
    dJointSetDrive(joint, 0, &axis.drive);
    const V3 before = momentum(sim);
    double q = 0, w = 2;
    const int parts = parts_of(GetParam());
    for (int i = 0; i < 100; ++i) {
        step(sim, GetParam(), kStep);
        for (int k = 0; k < parts; ++k) w = axis.next_rate(q, w, kStep / parts), q += kStep / parts * w;
        ASSERT_NEAR(double(dJointGetAxisRate(joint, 0)), w, 10 * kClose) << "step " << i;
    }
    EXPECT_NEAR(length(momentum(sim) - before), 0, tol(1e-11, 1e-4));
}

// A rotor of inertia I behind a gear of ratio n is an armature n^2 I; a wheel that turns n times as fast through
// a real gear shows it.
TEST_P(Drive, armature_is_a_geared_rotor)
{
    const double ratio = 3, rotor = 0.2, arm = 1.5, torque = 2;
    Sim sim;
    calm(sim);
    dBodyID link = sim.body({0, 0, 0}, 1, arm);
    dJointID hinge = dJointCreateHinge(sim.world, nullptr);
    dJointAttach(hinge, link, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dDrive drive = no_drive();
    drive.armature = real(ratio * ratio * rotor);
    drive.force = real(torque);
    dJointSetDrive(hinge, 0, &drive);
    step(sim, GetParam(), kStep, 50);
    EXPECT_NEAR(spin(link).z, torque * 50 * kStep / (arm + ratio * ratio * rotor), tol(1e-9, 1e-5));
}

// On a turntable that turns at W a bob of mass m slides outward with an armature I:  (m + I) r'' = m W^2 r, since the rotor
// does not turn about the table's axis. So r = r0 cosh(W sqrt(m / (m + I)) t).
TEST_P(Drive, armature_on_a_turntable_is_not_thrown_outward)
{
    for (const bool coupled : {false, true}) {
        SCOPED_TRACE(coupled ? "of a coupling" : "of the joint");
        const double turning = 2, r0 = 0.5, h = 0.0005;
        Sim sim;
        calm(sim);
        dWorldSetQuickStepNumIterations(sim.world, 100);
        const dBodyID table = sim.body({0, 0, 0}, 1e4, 1e4), bob = sim.body({r0, 0, 0}, 1);
        const dJointID axle = dJointCreateHinge(sim.world, nullptr),
                       rail = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(axle, table, nullptr), dJointAttach(rail, bob, table);
        dJointSetHingeAxis(axle, 0, 0, 1), dJointSetSliderAxis(rail, 1, 0, 0);
        dBodySetAngularVel(table, 0, 0, real(turning)), dBodySetAngularVel(bob, 0, 0, real(turning));
        velocity(bob, {0, turning * r0, 0});
        dDrive drive = no_drive();
        drive.armature = 3;
        dJointID driven = rail;
        if (coupled) {
            driven = dJointCreateCoupling(sim.world, nullptr);
            dJointSetCouplingAxis(driven, 0, rail, 0, 1);
            dJointSetCouplingParam(driven, dParamLoStop, -dInfinity);
            dJointSetCouplingParam(driven, dParamHiStop, dInfinity);
        }
        dJointSetDrive(driven, 0, &drive);
        step(sim, GetParam(), h, 1000);
        EXPECT_NEAR(length(position(bob)), r0 * std::cosh(turning * std::sqrt(0.25) * 1000 * h), 2e-3);
        EXPECT_NEAR(double(dJointGetDriveForce(driven, 0)), 0, 0.02) << "a rotor alone";
    }
}

double swing_distance(Way way, double h)
{
    Sim sim;
    dBodyID b = sim.body({0, 0, 0}, 1);
    dJointID joint = Drive::slider(sim, b, nullptr);
    dDrive drive = no_drive();
    drive.stiffness = 40, drive.damping = 1;
    dJointSetDrive(joint, 0, &drive);
    place(b, {0.5, 0, 0});
    const double decay = 0.5, w = std::sqrt(40 - decay * decay);
    double worst = 0;
    for (int i = 1, n = int(2 / h + 0.5); i <= n; ++i) {
        step(sim, way, h);
        const double t = i * h;
        const double x = 0.5 * std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t));
        worst = std::max(worst, std::fabs(position(b).x - x));
    }
    return worst;
}

TEST_P(Drive, converges_to_the_continuous_spring_at_first_order)
{
    const double coarse = swing_distance(GetParam(), 0.008), fine = swing_distance(GetParam(), 0.002);
    EXPECT_LT(fine, 0.05);
    EXPECT_LT(fine, 0.3 * coarse) << "first order: a quarter, with room";
}

// A passive drive never adds energy, however stiff and however long the step: kinetic energy of body and
// rotor and the spring's.
TEST_P(Drive, passive_never_gains_energy)
{
    for (const double k : {1.0, 1e3, 1e7}) {
        Sim sim;
        calm(sim);
        dBodyID b = sim.body({0, 0, 0}, 1);
        dJointID joint = slider(sim, b, nullptr);
        dDrive drive = no_drive();
        drive.stiffness = real(k), drive.armature = real(0.5), drive.friction = real(0.1);
        dJointSetDrive(joint, 0, &drive);
        velocity(b, {1, 0, 0});
        const auto energy = [&] {
            const double q = double(dJointGetAxisPosition(joint, 0)), w = double(dJointGetAxisRate(joint, 0));
            return 0.5 * (1.5 * w * w + k * q * q);
        };
        double last = energy();
        for (int i = 0; i < 200; ++i) {
            step(sim, GetParam(), 0.05);
            const double now = energy();
            ASSERT_LE(now, last + tol(1e-12, 1e-6)) << "k " << k << ", step " << i;
            last = now;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, Drive, testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace epode::physics
