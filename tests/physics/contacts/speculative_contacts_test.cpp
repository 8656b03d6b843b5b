// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What will touch before a step ends is met where it will touch, and what will not is left alone.
#include <algorithm>
#include <cmath>

#include "world_contacts.h"

namespace epode::physics {
namespace {

class SpeculativeContacts : public testing::TestWithParam<Stepper> {};

// What falls is met at the ground, not in it: at 8 m/s a step is 0.13 m long.
TEST_P(SpeculativeContacts, meet_what_falls)
{
    WorldContactsSim sim(GetParam());
    sim.ground();
    const dBodyID bodies[] = {sim.box({0, 0, 3.5}, {1, 1, 1}, 4), sim.sphere({5, 0, 3.5}, 0.5, 3),
                              sim.cylinder({10, 0, 3.5}, 0.5, 1, 5)};
    double deepest = 0, fastest = 0;
    for (int i = 0; i < 90; ++i) {
        sim.run(1);
        for (const dBodyID b : bodies) {
            deepest = std::max(deepest, 0.5 - position(b).z);
            fastest = std::max(fastest, length(velocity(b)));
        }
    }
    EXPECT_GT(fastest, 7);
    // Substeps share the closing among the corners, and take a few sweeps for it.
    EXPECT_LT(deepest, GetParam() == Stepper::kFast ? 0.02 : 0.001);
    for (const dBodyID b : bodies) EXPECT_NEAR(position(b).z, 0.5, 0.003);
}

// Flying past a wall 1 mm away is no contact.
TEST_P(SpeculativeContacts, that_never_come_about_do_nothing)
{
    WorldContactsSim sim(GetParam());
    sim.gravity(0, 0, 0);
    dGeomSetPosition(dCreateBox(sim.space, 1, 20, 20), real(-1.001), 0, 0);
    const dBodyID along = sim.box({0, -5, 0}, {1, 1, 1}, 1);
    velocity(along, {0, 9, 3});
    for (int i = 0; i < 30; ++i) {
        sim.run(1);
        EXPECT_TRUE(sim.events().empty()) << i;
        EXPECT_TRUE(sim.all_contacts().empty()) << i;
    }
    EXPECT_NEAR(length(velocity(along) - V3{0, 9, 3}), 0, 1e-6);
}

// Height of the lowest corner of a cube.
double lowest_corner(dBodyID cube, double side)
{
    const dReal* R = dBodyGetRotation(cube);
    const double reach = std::abs(R[8]) + std::abs(R[9]) + std::abs(R[10]);
    return position(cube).z - 0.5 * side * reach;
}

// The corner that lands first stops, and the one opposite comes down with the speed of the fall and of the
// turn about the first: neither sinks in, though at first only one is seen.
TEST_P(SpeculativeContacts, meet_all_corners_of_what_lands_on_one)
{
    for (double tilt = 0.02; tilt < 0.4; tilt += 0.01) {
        WorldContactsSim sim(GetParam());
        sim.ground();
        const dBodyID cube = sim.box({0, 0, 3.5}, {1, 1, 1}, 4);
        dQuaternion q = {1, real(tilt / 2), real(tilt / 3), 0};
        dSafeNormalize4(q);
        dBodySetQuaternion(cube, q);
        double deepest = 0;
        for (int i = 0; i < 90; ++i) {
            sim.run(1);
            deepest = std::max(deepest, -lowest_corner(cube, 1));
        }
        EXPECT_LT(deepest, GetParam() == Stepper::kFast ? 0.02 : 0.01) << tilt;
    }
}

// The normal is that of the place where the two will meet, and does not turn with who is thrown: the ground
// pushes upwards, so without friction nothing is pushed aside.
TEST_P(SpeculativeContacts, push_along_the_normal_that_will_be)
{
    for (const double spin : {3.0, 8.0, 15.0}) {
        WorldContactsSim sim(GetParam());
        sim.ground();
        const dBodyID bodies[] = {sim.box({0, 0, 3}, {1, 1, 1}, 4), sim.cylinder({10, 0, 3}, 0.5, 1, 5),
                                  sim.capsule({20, 0, 3}, 0.3, 1, 2)};
        for (const dBodyID b : bodies) set_material(geom_of(b), 0);
        for (const dBodyID b : bodies) velocity(b, {}, {spin, 0.7 * spin, 0.2 * spin});
        double aside = 0, up = 0;
        for (int i = 0; i < 120; ++i) {
            sim.run(1);
            for (const dBodyID b : bodies) {
                aside = std::max(aside, std::hypot(velocity(b).x, velocity(b).y));
                up = std::max(up, velocity(b).z);
            }
        }
        EXPECT_GT(up, 0.1) << spin;  // they have met the ground, and their turn has thrown them up again
        // (What has hardly moved keeps its normal, which then turns with it by some 1e-4.)
        EXPECT_LT(aside, 5e-4) << spin;
    }
}

// A gap that closes in this step is no depth: the projection of positions moves nobody back from it, and each
// body arrives where its velocity says.
TEST(ProjectedContacts, leave_what_is_about_to_touch_alone)
{
    WorldContactsSim sim(Stepper::kExact);
    sim.ground();
    dWorldSetStepProjection(sim.world, 2);
    const dBodyID bodies[] = {sim.box({0, 0, 1}, {1, 1, 1}, 4), sim.sphere({5, 0, 2}, 0.5, 3),
                              sim.cylinder({10, 0, 3.5}, 0.5, 1, 5)};
    for (int i = 0; i < 90; ++i) {
        const double before[] = {position(bodies[0]).z, position(bodies[1]).z, position(bodies[2]).z};
        sim.run(1);
        for (int k = 0; k < 3; ++k) {
            const double moved = position(bodies[k]).z - before[k];
            EXPECT_NEAR(moved, kH * velocity(bodies[k]).z, tol(1e-6, 2e-6)) << "step " << i << ", body " << k;
        }
    }
    for (const dBodyID b : bodies) EXPECT_NEAR(position(b).z, 0.5, 0.001);
}

INSTANTIATE_TEST_SUITE_P(Steppers, SpeculativeContacts, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
