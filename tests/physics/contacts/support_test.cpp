// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Statics. What carries a body at rest sums to its weight and to no torque. A rigid table on four legs is
// undetermined: of all answers the world's CFM picks the one of least sum of squares, which for a rectangle
// of half sides a, b and a load at (x, y) is W/4 (1 + sx x/a + sy y/b), whatever the order of the contacts.
#include <algorithm>
#include <array>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81;

struct Support : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    Support() { sim.gravity(0, 0, -kG); }
};

TEST_P(Support, of_a_box_on_the_ground_sums_to_its_weight)
{
    const double mass = 4, h = 0.01;
    dGeomID ground = sim.ground();
    dBodyID box = sim.box({0, 0, 0.25}, {1, 1, 0.5}, mass);
    sim.steps(300, h);
    dJointGroupEmpty(sim.contacts);
    std::array<dContact, 8> c;
    const int n = dCollide(dBodyGetFirstGeom(box), ground, 8, &c[0].geom, sizeof(dContact));
    ASSERT_GE(n, 3);
    std::array<dJointFeedback, 8> feedback{};
    for (std::size_t i = 0; i < std::size_t(n); ++i) {
        c[i].surface = sim.surface;
        dJointID joint = dJointCreateContact(sim.world, sim.contacts, &c[i]);
        dJointAttach(joint, box, nullptr);
        dJointSetFeedback(joint, &feedback[i]);
    }
    sim.advance(h);
    V3 force, torque;
    for (const dJointFeedback& f : feedback) {
        force = force + vec(f.f1), torque = torque + vec(f.t1);
        EXPECT_GE(f.f1[2], -1e-6) << "contacts never pull";
    }
    // The box still settles by less than a micrometre per second; iterating steppers end near the answer.
    const double tolerance = GetParam() == Stepper::kExact ? tol(1e-5, 2e-2) : 2e-2;
    EXPECT_NEAR(force.z, mass * kG, tolerance * mass * kG);
    EXPECT_LT(std::fabs(force.x) + std::fabs(force.y), tolerance * mass * kG);
    EXPECT_LT(length(torque), tolerance * mass * kG);
}

// Legs at (+-a, +-b), the centre of mass at (x, y) between them, contacts made in the given order; the four
// vertical forces in the order ++, +-, -+, --.
std::array<double, 4> leg_forces(Stepper stepper, double x, double y, const std::array<int, 4>& order,
                                 int steps, double cfm = -1)
{
    const double a = 0.8, b = 0.5, h = 0.01;
    Sim sim(stepper);
    if (cfm >= 0) dWorldSetCFM(sim.world, real(cfm));
    dWorldSetQuickStepNumIterations(sim.world, 200);
    sim.substeps = 4;
    sim.gravity(0, 0, -kG);
    dBodyID table = sim.body({x, y, 0.7}, 12, 3);
    std::array<dJointFeedback, 4> feedback{};
    for (int s = 0; s < steps; ++s) {
        dJointGroupEmpty(sim.contacts);
        for (int leg : order) {
            const V3 foot{leg < 2 ? a : -a, leg % 2 == 0 ? b : -b, 0};
            dContact c = make_contact(foot, {0, 0, 1}, 0);
            dJointID joint = dJointCreateContact(sim.world, sim.contacts, &c);
            dJointAttach(joint, table, nullptr);
            dJointSetFeedback(joint, &feedback[std::size_t(leg)]);
        }
        sim.advance(h);
    }
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = double(feedback[i].f1[2]);
    return out;
}

std::array<double, 4> even_legs(double x, double y)
{
    const double w = 12 * kG / 4, dx = x / 0.8, dy = y / 0.5;
    return {w * (1 + dx + dy), w * (1 + dx - dy), w * (1 - dx + dy), w * (1 - dx - dy)};
}

constexpr std::array<std::array<int, 4>, 4> kOrders{{{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}, {1, 3, 0, 2}}};

TEST(TableOnFourLegs, shares_its_load_evenly_whatever_the_order_of_the_legs)
{
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.2, 0.0}, {0.1, -0.2}, {-0.3, 0.1}})
        for (const auto& order : kOrders) {
            const auto got = leg_forces(Stepper::kExact, x, y, order, 1), want = even_legs(x, y);
            // Softness of 1e-8 against mobilities of 1 leaves eight digits to the undetermined part.
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(got[i], want[i], tol(1e-5, 0.2)) << x << ' ' << y << " leg " << i;
        }
}

TEST(TableOnFourLegs, without_softness_still_balances_and_keeps_still)
{
    for (const auto& order : kOrders) {
        const auto f = leg_forces(Stepper::kExact, 0.1, -0.2, order, 1, 0);
        // A contact may close by eight epsilon of its place (0.8 m) in a step, for which no force acts.
        const double closing = 12 * 8 * kEpsilon * 0.8 / (0.01 * 0.01);
        const double tolerance = tol(1e-8, 2e-3) + closing;
        EXPECT_NEAR(f[0] + f[1] + f[2] + f[3], 12 * kG, tolerance);
        EXPECT_NEAR(0.8 * (f[0] + f[1] - f[2] - f[3]), 0.1 * 12 * kG, tolerance);
        EXPECT_NEAR(0.5 * (f[0] - f[1] + f[2] - f[3]), -0.2 * 12 * kG, tolerance);
        for (double leg : f) EXPECT_GE(leg, 0);
    }
}

TEST_P(Support, of_a_table_balances_its_load)
{
    const auto f = leg_forces(GetParam(), 0.1, -0.2, kOrders[2], 100);
    const double tolerance = GetParam() == Stepper::kExact ? tol(1e-6, 1e-2) : 1e-2 * 12 * kG;
    EXPECT_NEAR(f[0] + f[1] + f[2] + f[3], 12 * kG, tolerance);
    EXPECT_NEAR(0.8 * (f[0] + f[1] - f[2] - f[3]), 0.1 * 12 * kG, tolerance);
    EXPECT_NEAR(0.5 * (f[0] - f[1] + f[2] - f[3]), -0.2 * 12 * kG, tolerance);
}

TEST_P(Support, of_a_beam_on_a_fixed_joint_is_force_and_moment)
{
    const double mass = 2, arm = 1.5;
    dBodyID wall = sim.body({0, 0, 0});
    dBodySetKinematic(wall);
    dBodyID beam = sim.body({arm, 0, 0}, mass);
    dJointID weld = dJointCreateFixed(sim.world, nullptr);
    dJointAttach(weld, wall, beam);
    dJointSetFixed(weld);
    dJointFeedback feedback{};
    dJointSetFeedback(weld, &feedback);
    dWorldSetQuickStepNumIterations(sim.world, 200);
    for (int i = 0; i < 200; ++i) sim.advance(0.005);
    const double tolerance = GetParam() == Stepper::kExact ? tol(1e-6, 1e-2) : 0.02 * mass * kG;
    EXPECT_NEAR(feedback.f2[2], mass * kG, tolerance);
    EXPECT_NEAR(feedback.f1[2], -mass * kG, tolerance);
    // Force at the beam's centre: the wall feels its weight at the arm.
    EXPECT_NEAR(std::fabs(feedback.t1[1] - feedback.t2[1] * -1), arm * mass * kG,
                arm * tolerance + tolerance);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Support, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
