// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two balls that a world's contacts stop within a step are stopped where they touch: a ball that hits an equal one half full, without
// friction and with restitution 1, goes on at 60 degrees, the other at 30, and neither turns. (Found at the step's end they gave each
// other a normal 10 degrees off, and a spin that took 22 percent of the energy.)
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kRadius = 0.0285, kBall = 0.17, kSpeed = 2, kEnergy = kBall * kSpeed * kSpeed / 2;

class BallsMeet : public testing::TestWithParam<Stepper> {
  protected:
    WorldContactsSim sim{GetParam()};
    dBodyID white = nullptr, red = nullptr;

    // `aside`: of the centres' ways, m; `at`: how far away the white ball begins.
    void set_up(double speed, double aside, double at)
    {
        sim.gravity(0, 0, 0);
        dWorldSetContactSurfaceLayer(sim.world, 0);
        white = sim.sphere({-at, aside, 0}, kRadius, kBall);
        red = sim.sphere({}, kRadius, kBall);
        for (const dBodyID ball : {white, red}) set_material(geom_of(ball), 0, 1);
        velocity(white, {speed, 0, 0});
    }

    double spin_energy() const
    {
        const double inertia = 0.4 * kBall * kRadius * kRadius;
        return inertia / 2 * (dot(spin(white), spin(white)) + dot(spin(red), spin(red)));
    }
};

TEST_P(BallsMeet, in_the_direction_in_which_they_touch)
{
    for (const double at : {0.3, 0.308, 0.316, 0.324, 0.332}) {  // phases of a step
        set_up(kSpeed, kRadius, at);
        sim.run(15);
        EXPECT_NEAR(velocity(white).x, 0.5, 0.01);
        EXPECT_NEAR(velocity(white).y, std::sqrt(0.75), 0.01);
        EXPECT_NEAR(velocity(red).x, 1.5, 0.01);
        EXPECT_NEAR(velocity(red).y, -std::sqrt(0.75), 0.01);
        // Substeps move the balls on between the blow and the rebound.
        EXPECT_LT(spin_energy(), GetParam() == Stepper::kFast ? 0.1 * kEnergy : 1e-6 * kEnergy) << at;
        for (const dBodyID ball : {white, red}) dBodyDisable(ball), place(ball, {0, 0, 100 + 10 * at});
    }
}

TEST_P(BallsMeet, only_where_they_touch)
{
    set_up(3, 2.01 * kRadius, 0.3);
    sim.run(20);
    EXPECT_EQ(velocity(white).x, 3);
    EXPECT_EQ(length(velocity(red)), 0);
}

INSTANTIATE_TEST_SUITE_P(Steppers, BallsMeet, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
