// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies without joints. v_n = v_0 + n h g and x_n = x_0 + n h v_0 + g h^2 n (n+1)/2 for semi-implicit Euler;
// the small-step method cuts h into k parts, hence n k in place of n. Turning: a step by quaternion addition
// turns by 2 atan(w h/2), a finite one by w h. A free top: the axis of a symmetric one circles L at |L|/I1;
// the implicit gyroscopic step never adds energy, and keeps |L| up to the first order of h.
#include "rig.h"

namespace epode::physics {
namespace {

struct FreeFlight : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
};

TEST_P(FreeFlight, follows_the_discrete_sum_of_semi_implicit_euler)
{
    sim.gravity(0, 0, -9.81);
    dBodyID b = sim.body({1, 2, 3});
    velocity(b, {1, -2, 4});
    const int n = 100, k = GetParam() == Stepper::kFast ? sim.substeps : 1;
    const double h = 0.01, hs = h / k, N = double(n) * k;
    for (int i = 0; i < n; ++i) ASSERT_EQ(sim.advance(h), 1);
    // Every addition rounds once; values stay below 8.
    const double tolerance = 8 * N * kEpsilon;
    EXPECT_NEAR(position(b).x, 2, tolerance);
    EXPECT_NEAR(position(b).y, 0, tolerance);
    EXPECT_NEAR(position(b).z, 3 + 4 - 9.81 * hs * hs * N * (N + 1) / 2, tolerance);
    EXPECT_NEAR(velocity(b).z, 4 - 9.81, tolerance);
}

TEST_P(FreeFlight, a_force_acts_for_one_step_only)
{
    dBodyID b = sim.body({0, 0, 0}, 2, 4);
    dBodyAddForce(b, 6, 0, 0);
    dBodyAddTorque(b, 0, 8, 0);
    sim.advance(0.5);
    sim.advance(0.5);
    EXPECT_NEAR(velocity(b).x, 1.5, 20 * kEpsilon);
    EXPECT_NEAR(spin(b).y, 1, 20 * kEpsilon);
}

TEST_P(FreeFlight, a_body_out_of_gravity_keeps_its_velocity_to_the_bit)
{
    sim.gravity(0, 0, -9.81);
    dBodyID b = sim.body({0, 0, 0});
    dBodySetGravityMode(b, 0);
    velocity(b, {0.3, -0.7, 0.1});
    for (int i = 0; i < 50; ++i) sim.advance(0.01);
    EXPECT_EQ(dBodyGetLinearVel(b)[0], real(0.3));
    EXPECT_EQ(dBodyGetLinearVel(b)[2], real(0.1));
}

TEST_P(FreeFlight, a_finite_rotation_turns_by_exactly_w_h)
{
    // One small step per step: then both modes have a closed form of the same h. Otherwise than ODE's, both are exact.
    sim.substeps = 1;
    dWorldSetBehaviour(sim.world, dBehaviour016);
    dBodyID finite = sim.body({0, 0, 0}), infinitesimal = sim.body({9, 0, 0});
    dBodySetFiniteRotationMode(finite, 1);
    const V3 w{2, -3, 6};  // length 7
    velocity(finite, {}, w);
    velocity(infinitesimal, {}, w);
    const int n = 300;
    const double h = 0.02, turns[2] = {n * 7 * h / 2, n * std::atan(7 * h / 2)};
    for (int i = 0; i < n; ++i) sim.advance(h);
    for (int k = 0; k < 2; ++k) {
        const dReal* q = dBodyGetQuaternion(k == 0 ? finite : infinitesimal);
        const double sign = std::cos(turns[k]) * q[0] + std::sin(turns[k]) * q[3] * 7 / 6 < 0 ? -1 : 1;
        // Each step rounds and normalises once.
        const double tolerance = 4 * n * kEpsilon;
        EXPECT_NEAR(sign * q[0], std::cos(turns[k]), tolerance) << k;
        EXPECT_NEAR(sign * q[1], std::sin(turns[k]) * 2 / 7, tolerance) << k;
        EXPECT_NEAR(sign * q[3], std::sin(turns[k]) * 6 / 7, tolerance) << k;
    }
}

TEST_P(FreeFlight, damping_scales_the_velocity_once_per_step_above_the_threshold)
{
    dBodyID b = sim.body({0, 0, 0}), still = sim.body({5, 0, 0});
    for (dBodyID each : {b, still}) {
        dBodySetDamping(each, real(0.25), real(0.5));
        dBodySetLinearDampingThreshold(each, real(0.5));
        dBodySetAngularDampingThreshold(each, real(0.5));
    }
    velocity(b, {4, 0, 0}, {0, 0, 8});
    velocity(still, {0.5, 0, 0}, {0, 0.5, 0});  // exactly at the threshold: not damped
    for (int i = 0; i < 7; ++i) sim.advance(0.01);
    EXPECT_NEAR(velocity(b).x, 4 * std::pow(0.75, 7), 20 * kEpsilon);
    EXPECT_NEAR(spin(b).z, 0.5, 0) << "four halvings, then at the threshold";
    EXPECT_EQ(velocity(still).x, 0.5);
    EXPECT_EQ(spin(still).y, 0.5);
    for (int i = 0; i < 9; ++i) sim.advance(0.01);
    EXPECT_GT(velocity(b).x, 0.5 * 0.75 - 1e-6);
    EXPECT_LE(velocity(b).x, 0.5);
}

TEST_P(FreeFlight, the_angular_speed_is_capped)
{
    dBodyID b = sim.body({0, 0, 0});
    dBodySetMaxAngularSpeed(b, 2);
    velocity(b, {}, {6, 0, -8});
    sim.advance(0.01);
    EXPECT_NEAR(spin(b).x, 1.2, 20 * kEpsilon);
    EXPECT_NEAR(spin(b).z, -1.6, 20 * kEpsilon);
    velocity(b, {}, {1, 0, 0});
    sim.advance(0.01);
    EXPECT_EQ(spin(b).x, 1);
}

TEST_P(FreeFlight, a_kinematic_body_keeps_its_course)
{
    sim.gravity(0, 0, -9.81);
    dBodyID b = sim.body({0, 0, 0});
    dBodySetKinematic(b);
    velocity(b, {1, 0, 0});
    dBodyAddForce(b, 100, 100, 100);
    for (int i = 0; i < 100; ++i) sim.advance(0.01);
    EXPECT_NEAR(position(b).x, 1, 1000 * kEpsilon);
    EXPECT_EQ(position(b).z, 0);
}

// A top of inertia (i1, i1, i3) with spin (wx, 0, wz): angle by which its axis circles L after one second.
double precession_after_a_second(Stepper stepper, double h, double i1, double i3, V3 w)
{
    Sim sim(stepper);
    sim.substeps = 2;
    dBodyID b = sim.body({0, 0, 0});
    dMass m;
    dMassSetParameters(&m, 1, 0, 0, 0, real(i1), real(i1), real(i3), 0, 0, 0);
    dBodySetMass(b, &m);
    dBodySetFiniteRotationMode(b, 1);
    velocity(b, {}, w);
    const V3 L = spin_momentum(b), axis = (1 / length(L)) * L;
    const auto pointer = [&] {
        const dReal* R = dBodyGetRotation(b);
        const V3 a{R[2], R[6], R[10]};
        return a - dot(a, axis) * axis;
    };
    const V3 start = pointer(), side = cross(axis, start);
    double angle = 0, last = 0;
    for (int i = 0, n = int(1 / h + 0.5); i < n; ++i) {
        sim.advance(h);
        const V3 p = pointer();
        const double now = std::atan2(dot(p, side), dot(p, start));
        double change = now - last;
        if (change < -kPi) change += 2 * kPi;
        if (change > kPi) change -= 2 * kPi;
        angle += change;
        last = now;
    }
    return angle;
}

TEST_P(FreeFlight, a_symmetric_top_circles_its_angular_momentum_at_l_over_i1)
{
    const double i1 = 1, i3 = 2;
    const V3 w{0.5, 0, 1.5};
    const double rate = std::sqrt(i1 * i1 * w.x * w.x + i3 * i3 * w.z * w.z) / i1;
    const double coarse = precession_after_a_second(GetParam(), 1 / 128., i1, i3, w) - rate;
    const double fine = precession_after_a_second(GetParam(), 1 / 512., i1, i3, w) - rate;
    EXPECT_LT(std::fabs(fine), 0.01 * rate) << "0.2 % of a radian per step";
    // Each of 512 steps rounds the orientation, by up to an epsilon.
    EXPECT_LT(std::fabs(fine), 0.4 * std::fabs(coarse) + 512 * kEpsilon)
        << "first order: a quarter, with a margin";
}

// Largest rise of the energy in one step and drift of |L|, both relative, of a box tumbling for two seconds.
void tumble(Stepper stepper, double h, double& rise, double& drift)
{
    Sim sim(stepper);
    sim.substeps = 2;
    dBodyID b = sim.box({0, 0, 0}, {1, 2, 3}, 1);
    velocity(b, {}, {0.01, 2, 0.02});  // about the middle axis: it turns over
    const double L0 = length(spin_momentum(b)), E0 = kinetic_energy(b);
    double E = E0;
    rise = 0;
    for (int i = 0, n = int(8 / h + 0.5); i < n; ++i) {
        sim.advance(h);
        const double now = kinetic_energy(b);
        rise = std::max(rise, (now - E) / E0);
        E = now;
    }
    drift = std::fabs(length(spin_momentum(b)) - L0) / L0;
}

TEST_P(FreeFlight, a_tumbling_box_gains_no_energy_and_keeps_its_angular_momentum)
{
    double rise[2], drift[2];
    tumble(GetParam(), 1 / 64., rise[0], drift[0]);
    tumble(GetParam(), 1 / 256., rise[1], drift[1]);
    // R I R^T is formed again from a rounded quaternion in every step.
    for (double r : rise) EXPECT_LT(r, 40 * kEpsilon);
    EXPECT_LT(drift[1], 0.02);
    EXPECT_LT(drift[1], 0.4 * drift[0] + 1e4 * kEpsilon) << "first order: a quarter, with a margin";
}

INSTANTIATE_TEST_SUITE_P(Steppers, FreeFlight, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
