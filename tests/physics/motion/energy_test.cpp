// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Without motors energy only goes away: joints, friction and inelastic contacts dissipate, the first order of
// the integrator makes small waves. Bounds are shares of the energy that is there to begin with.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

struct Energy : testing::TestWithParam<Stepper> {
    Sim sim{GetParam()};
    Energy() { sim.gravity(0, 0, -9.81); }
};

// A chain of n balls of mass 1, level, its first ball joint at the origin.
void hang_chain(Sim& sim, int n, double last_mass = 1)
{
    dBodyID before = nullptr;
    for (int i = 0; i < n; ++i) {
        dBodyID b = sim.body({0.25 + 0.5 * i, 0, 0}, i == n - 1 ? last_mass : 1, 0.05);
        dJointID j = dJointCreateBall(sim.world, nullptr);
        dJointAttach(j, b, before);
        dJointSetBallAnchor(j, real(0.5 * i), 0, 0);
        before = b;
    }
}

TEST_P(Energy, of_a_swinging_chain_never_exceeds_what_it_began_with)
{
    const int n = 8;
    hang_chain(sim, n);
    const double start = energy(sim), depth = 9.81 * n * (0.5 * n);
    double largest = start;
    for (int i = 0; i < 2000; ++i) {
        ASSERT_EQ(sim.advance(0.005), 1);
        largest = std::max(largest, energy(sim));
    }
    EXPECT_TRUE(finite_state(sim));
    EXPECT_LT(largest - start, 0.02 * depth);
    EXPECT_GT(energy(sim), start - depth) << "and is not below that of the hanging chain";
}

TEST_P(Energy, of_a_settling_pile_goes_down)
{
    Random random(3);
    sim.ground();
    // Found as deep as v h = 5 cm, bodies are pushed out again; not faster than this.
    dWorldSetContactMaxCorrectingVel(sim.world, 1);
    sim.surface.mode |= dContactRolling;  // or balls roll for ever
    sim.surface.rho = real(0.02);
    for (int i = 0; i < 40; ++i) {
        const V3 at{random.uniform(-1, 1), random.uniform(-1, 1), 0.5 + 0.3 * i};
        dBodyID b = i % 3 == 0   ? sim.box(at, {0.5, 0.4, 0.3}, 1)
                    : i % 3 == 1 ? sim.sphere(at, 0.25, 1)
                                 : sim.capsule(at, 0.15, 0.4, 1);
        dQuaternion q;
        random.quaternion(q);
        dBodySetQuaternion(b, q);
    }
    const double h = 0.005, start = energy(sim);
    double least = start, worst_rise = 0;
    for (int i = 0; i < 1600; ++i) {
        ASSERT_EQ(sim.step(h), 1);
        const double now = energy(sim);
        worst_rise = std::max(worst_rise, now - least);
        least = std::min(least, now);
    }
    EXPECT_LT(worst_rise, 0.01 * start);
    double moving = 0;
    for (dBodyID b : sim.bodies) moving += kinetic_energy(b);
    EXPECT_LT(moving, 0.01 * start) << "mostly at rest after eight seconds";
}

TEST_P(Energy, of_a_stack_at_rest_stays_at_rest)
{
    sim.ground();
    // The guide's advice for stacks: corners that are lifted by a rounding stay in contact.
    dWorldSetContactSurfaceLayer(sim.world, real(0.001));
    for (int i = 0; i < 5; ++i) sim.box({0, 0, 0.25 + 0.5 * i}, {0.5, 0.5, 0.5}, 2);
    sim.steps(300, 0.01);
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
        sim.step(0.01);
        double moving = 0;
        for (dBodyID b : sim.bodies) moving += kinetic_energy(b);
        largest = std::max(largest, moving);
    }
    // 10 kg at a millimetre per second; the iterating steppers leave a tremble.
    const double speed = GetParam() == Stepper::kExact ? 1e-3 : GetParam() == Stepper::kQuick ? 4e-2 : 5e-3;
    EXPECT_LT(largest, 0.5 * 10 * speed * speed);
}

INSTANTIATE_TEST_SUITE_P(Steppers, Energy, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
