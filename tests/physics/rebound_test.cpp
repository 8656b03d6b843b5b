// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Restitution in every way to step: a ball on world-managed contacts rises to e^2 of the height that it fell
// from, after one rebound and after ten, whatever part of a step is left when it lands.
#include "drive_ways.h"

namespace epode::physics {
namespace {

struct Rebound : testing::TestWithParam<Way> {
    // The highest place of the ball, m above rest, between these times, s.
    static double top(double restitution, double h, double from, double to, bool manifold_friction = false)
    {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldSetCFM(sim.world, 0);  // that of floats, 1e-5, takes a thousandth of each rebound
        dWorldSetContactSpace(sim.world, sim.space);
        dWorldSetManifoldFriction(sim.world, manifold_friction);
        sim.ground();
        dBodyID ball = sim.sphere({0, 0, 2.5}, 0.5, 1);
        dMaterial rubber;
        dMaterialInit(&rubber, sizeof rubber);
        rubber.bounce = real(restitution), rubber.bounce_speed = real(0.01);
        dGeomSetMaterial(dBodyGetFirstGeom(ball), &rubber);
        double highest = 0;
        for (int i = 0; i < int(to / h); ++i) {
            epode::physics::step(sim, GetParam(), h);
            if (i * h > from) highest = std::max(highest, position(ball).z - 0.5);
        }
        return highest;
    }
};
INSTANTIATE_TEST_SUITE_P(Ways, Rebound, testing::ValuesIn(kWays), way_name);

TEST_P(Rebound, elastic_ball_keeps_its_height)
{
    for (double h : {1.0 / 60, 1.0 / 100, 1.0 / 240})
        for (bool manifold_friction : {false, true}) {
            const double height = top(1, h, 12.5, 15, manifold_friction);
            EXPECT_GT(height, 1.98) << "h = " << h;
            EXPECT_LT(height, 2.03) << "h = " << h;
        }
}

TEST_P(Rebound, rises_to_the_square_of_its_restitution)
{
    EXPECT_NEAR(top(0.5, 1.0 / 240, 0.7, 1.2), 0.25 * 2, 0.03);
}

}  // namespace
}  // namespace epode::physics
