// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free bodies in substeps and hybrid steps: forces of the program are kicks of semi-implicit Euler, so
// springs and orbits keep their energy, and exact rotation turns exactly.
#include <algorithm>
#include <string>
#include <tuple>

#include "scenes.h"

namespace epode::physics {
namespace {

enum class Way { kFast, kHybrid };

class FreeInSubsteps : public testing::TestWithParam<std::tuple<Way, bool>> {
  protected:
    FreeInSubsteps()
    {
        if (std::get<1>(GetParam())) dWorldSetContactSpace(sim.world, sim.space);
        sim.substeps = kSubsteps;
        dWorldSetHybridSubsteps(sim.world, kSubsteps);
    }

    void step(double h)
    {
        const bool fast = std::get<0>(GetParam()) == Way::kFast;
        ASSERT_EQ(fast ? sim.advance(h) : dWorldStepHybrid(sim.world, real(h)), 1);
    }

    static constexpr int kSubsteps = 4;
    Sim sim{Stepper::kFast};
};

// v' = v - h k x, x' = x + h v': the recurrence itself, and what it keeps, x^2 + v^2 / k - h x v.
TEST_P(FreeInSubsteps, takes_a_spring_as_semi_implicit_euler_does)
{
    constexpr double k = 100, h = 0.01;
    const dBodyID body = sim.body({1, 0, 0});
    double x = 1, v = 0;
    for (int i = 0; i < 3000; ++i) {
        const V3 at = position(body);
        dBodyAddForce(body, real(-k * at.x), 0, 0);
        step(h);
        v -= h * k * x, x += h * v;
        ASSERT_NEAR(position(body).x, x, tol(1e-11, 2e-3)) << i;
    }
    const V3 at = position(body), u = velocity(body);
    EXPECT_NEAR(at.x * at.x + u.x * u.x / k - h * at.x * u.x, 1, tol(1e-10, 2e-3));
}

// A circle about a planet, a thousand steps a turn, ten turns.
TEST_P(FreeInSubsteps, stays_on_an_orbit)
{
    constexpr double kTurn = 1000, h = 2 * kPi / kTurn;
    const dBodyID body = sim.body({1, 0, 0});
    velocity(body, {0, 1, 0});
    double lowest = 1, highest = 1;
    for (int i = 0; i < 10 * int(kTurn); ++i) {
        const V3 at = position(body);
        const double r = length(at), pull = 1 / (r * r * r);
        dBodyAddForce(body, real(-pull * at.x), real(-pull * at.y), 0);
        step(h);
        lowest = std::min(lowest, r), highest = std::max(highest, r);
    }
    EXPECT_GT(lowest, 0.99);
    EXPECT_LT(highest, 1.01);
}

// About its middle axis for a minute at 1/60 s. Substeps alone lose 17 % of the energy, whoever manages contacts.
TEST_P(FreeInSubsteps, tumbles_without_loss)
{
    for (const double kept : {1.0, 0.826}) {
        if (kept < 1) dWorldSetBehaviour(sim.world, dBehaviour016);
        const dBodyID body = sim.body({0, 0, 0});
        dMass mass;
        dMassSetParameters(&mass, 1, 0, 0, 0, 1, 2, real(2.8), 0, 0, 0);
        dBodySetMass(body, &mass);
        velocity(body, {}, {0.01, 5, 0.01});
        const double before = kinetic_energy(body);
        for (int i = 0; i < 3600; ++i) step(1.0 / 60);
        EXPECT_NEAR(kinetic_energy(body) / before, kept, kept < 1 ? 0.01 : tol(1e-9, 1e-2));
        dBodyDestroy(body);
    }
}

// Gravity alone is divided: the parabola of substeps, x = g h^2 (n + 1)/(2n) in the first step.
TEST_P(FreeInSubsteps, falls_as_before)
{
    constexpr double h = 0.1;
    sim.gravity(0, 0, -10);
    const dBodyID body = sim.body({0, 0, 0});
    step(h);
    EXPECT_NEAR(position(body).z, -10 * h * h * (kSubsteps + 1) / (2.0 * kSubsteps), tol(1e-15, 1e-7));
    EXPECT_NEAR(velocity(body).z, -10 * h, tol(1e-15, 1e-6));
}

TEST_P(FreeInSubsteps, adds_gravity_and_the_programs_force)
{
    constexpr double h = 0.1;
    sim.gravity(0, 0, -10);
    const dBodyID body = sim.body({0, 0, 0}, 2);
    dBodyAddForce(body, 6, 0, 0);
    dBodyAddTorque(body, 0, 0, 5);
    step(h);
    EXPECT_NEAR(position(body).x, 3 * h * h, tol(1e-15, 1e-7));
    EXPECT_NEAR(position(body).z, -10 * h * h * (kSubsteps + 1) / (2.0 * kSubsteps), tol(1e-15, 1e-7));
    EXPECT_NEAR(velocity(body).x, 3 * h, tol(1e-15, 1e-6));
    EXPECT_NEAR(spin(body).z, 5 * h, tol(1e-15, 1e-6));
}

// A brick that tumbles about its middle axis keeps energy and angular momentum, direction included, for 60 s.
TEST_P(FreeInSubsteps, turns_exactly_when_asked_to)
{
    dWorldSetExactRotation(sim.world, 1);
    const dBodyID body = sim.box({0, 0, 0}, {1, 2, 3}, 5);
    velocity(body, {1, 0, 0}, {0.1, 4, 0.05});
    const double energy = kinetic_energy(body);
    const V3 momentum = spin_momentum(body);
    for (int i = 0; i < 3600; ++i) step(1.0 / 60);
    // In floats each of 3,600 steps rounds.
    EXPECT_NEAR(kinetic_energy(body) / energy, 1, tol(1e-11, 1e-3));
    EXPECT_LT(length(spin_momentum(body) - momentum) / length(momentum), tol(1e-11, 2e-3));
    EXPECT_NEAR(position(body).x, 60, tol(1e-10, 1e-2));
}

std::string flight_name(const testing::TestParamInfo<std::tuple<Way, bool>>& info)
{
    const auto [way, world_contacts] = info.param;
    return std::string(way == Way::kFast ? "fast" : "hybrid") + (world_contacts ? "_world_contacts" : "");
}

INSTANTIATE_TEST_SUITE_P(Ways, FreeInSubsteps,
                         testing::Combine(testing::Values(Way::kFast, Way::kHybrid), testing::Bool()),
                         flight_name);

}  // namespace
}  // namespace epode::physics
