// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where along a floor a body lies changes nothing: how deep it rests, and how it is braked while it slides, by mu m g where manifolds share friction (a pyramid of single contacts takes more). Places are powers of two, which
// corners at half a metre from them keep in floats. (Floats let a box sink by 1e-6 of how far away it was: 0.9 mm at 1,024 m.)
#include "rig.h"

namespace epode::physics {
namespace {

struct FarSlide {
    double depth, rate;
};

FarSlide slide_at(double x, int manifold_friction)
{
    const double h = 0.002, speed = 3, along = 0.6;  // x speed along, y speed 0.8
    const int steps = 100;
    Sim sim(Stepper::kFast);
    sim.gravity(0, 0, -9.81);
    sim.surface.mu = real(0.4);
    dWorldSetManifoldFriction(sim.world, manifold_friction);
    sim.ground();
    const dBodyID box = sim.box({x, 0, 0.1}, {1, 1, 0.2}, 5);
    for (int i = 0; i < steps; ++i) sim.step(h);
    const double depth = 0.1 - position(box).z;
    velocity(box, {along * speed, 0.8 * speed, 0});
    for (int i = 0; i < steps; ++i) sim.step(h);
    return {depth, (speed - length(velocity(box))) / (steps * h)};
}

class FarAlongAFloor : public testing::TestWithParam<double> {};

TEST_P(FarAlongAFloor, a_box_rests_and_slides_as_at_the_origin)
{
    for (const int manifold_friction : {0, 1}) {
        const FarSlide near = slide_at(0, manifold_friction), far = slide_at(GetParam(), manifold_friction);
        EXPECT_NEAR(far.depth, near.depth, 1e-6) << manifold_friction;
        EXPECT_NEAR(far.rate, near.rate, 0.01 * near.rate) << manifold_friction;
        if (manifold_friction) { EXPECT_NEAR(far.rate, 0.4 * 9.81, 0.01 * 0.4 * 9.81); }
    }
}

INSTANTIATE_TEST_SUITE_P(Places, FarAlongAFloor, testing::Values(64.0, 1024.0));

}  // namespace
}  // namespace epode::physics
