// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What cannot be made to fit stays where it is, nearly: the projection of the robot's preset does not look for poses far away.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

// Two kinematic rams squeeze three crates by a third of a crate, and go back. (A crate was put 14 m up, where the contacts' normals,
// which differed by rounding, agreed.)
TEST(ProjectionReach, leaves_crates_between_rams)
{
    for (const double h : {1.0 / 60, 1.0 / 240}) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldUseDefaults(sim.world, dDefaultsRobot);
        dWorldSetContactSpace(sim.world, sim.space);
        sim.ground();
        for (const double x : {-0.52, 0.0, 0.52}) sim.box({x, 0, 0.25}, {0.5, 0.5, 0.5}, 20);
        const dBodyID rams[] = {sim.box({-1, 0, 1.05}, {0.2, 2, 2}, 1),
                                sim.box({1, 0, 1.05}, {0.2, 2, 2}, 1)};
        for (const dBodyID ram : rams) dBodySetKinematic(ram);
        double highest = 0, fastest = 0, jump = 0;
        for (double t = 0; t < 3; t += h) {
            const double speed = t < 1.75 ? 0.2 : -1;
            velocity(rams[0], {speed, 0, 0}), velocity(rams[1], {-speed, 0, 0});
            V3 before[3];
            for (int i = 0; i < 3; ++i) before[i] = position(sim.bodies[std::size_t(i)]);
            ASSERT_TRUE(dWorldStepHybrid(sim.world, real(h)));
            for (int i = 0; i < 3; ++i) {
                highest = std::max(highest, position(sim.bodies[std::size_t(i)]).z);
                jump = std::max(jump, length(position(sim.bodies[std::size_t(i)]) - before[i]));
                fastest = std::max(fastest, length(velocity(sim.bodies[std::size_t(i)])));
            }
        }
        EXPECT_LT(highest, 0.8) << h;  // one may slip up, and lie on others
        EXPECT_LT(jump, 0.5) << h;     // by no more than crates overlap
        EXPECT_LT(fastest, 2) << h;
    }
}

// A lift comes down at 3 m/s with crates on it, past its stop by up to a step's way, and is back at it within a tenth of a second. (It stayed 43 mm
// below for good: crates reach less far than that in a correction, and so it was refused whole.)
TEST(ProjectionReach, takes_a_loaded_lift_back_to_its_stop)
{
    for (const double h : {1.0 / 60, 1.0 / 240}) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        dWorldUseDefaults(sim.world, dDefaultsRobot);
        dWorldSetContactSpace(sim.world, sim.space);
        const dBodyID platform = sim.box({0, 0, 0}, {2, 2, 0.1}, 200);
        for (int i = 0; i < 12; ++i)
            sim.box({i % 2 ? 0.25 : -0.25, i / 2 % 2 ? 0.25 : -0.25, 0.25 + 0.4 * (i / 4)}, {0.4, 0.4, 0.4},
                    20);
        const dJointID slider = dJointCreateSlider(sim.world, nullptr);
        dJointAttach(slider, platform, nullptr);
        dJointSetSliderAxis(slider, 0, 0, 1);
        dJointSetSliderParam(slider, dParamLoStop, real(-1));
        dJointSetSliderParam(slider, dParamFMax, 20000);
        dJointSetSliderParam(slider, dParamVel, -3);
        for (double t = 0; t < 0.5; t += h) ASSERT_TRUE(dWorldStepHybrid(sim.world, real(h)));
        EXPECT_NEAR(double(dJointGetSliderPosition(slider)), -1, 1e-3) << h;
        EXPECT_NEAR(position(sim.bodies.back()).z, 0.05, 5e-3) << h;  // of the top crate
    }
}

}  // namespace
}  // namespace epode::physics
