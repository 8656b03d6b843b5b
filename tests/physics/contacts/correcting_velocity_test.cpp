// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldSetContactMaxCorrectingVel counts in every stepper: a box deep in the ground rises at that speed, and without the setting
// faster.
#include <algorithm>
#include <tuple>

#include "rig.h"

namespace epode::physics {
namespace {

enum class Way { kExact, kProjected, kQuick, kFast, kHybrid };
constexpr const char* kNames[] = {"exact", "projected", "quick", "fast", "hybrid"};

// The way, and whether the contacts are the world's.
class CorrectingVelocity : public testing::TestWithParam<std::tuple<Way, bool>> {
  protected:
    static constexpr double kH = 0.005, kDepth = 0.3;

    // How high a box of 1 m, kDepth in the ground, rises in each of `steps` steps without weight.
    static std::vector<double> rises(double bound, int steps)
    {
        const auto [way, by_world] = GetParam();
        Sim sim(way == Way::kQuick ? Stepper::kQuick : way == Way::kFast ? Stepper::kFast : Stepper::kExact);
        sim.gravity(0, 0, 0);
        if (way == Way::kProjected) dWorldSetStepProjection(sim.world, 10);
        dWorldSetContactMaxCorrectingVel(sim.world, real(bound));
        dWorldSetAutoDisableFlag(sim.world, 0);
        sim.ground();
        const dBodyID box = sim.box({0, 0, 0.5 - kDepth}, {1, 1, 1}, 1);
        if (by_world) dWorldSetContactSpace(sim.world, sim.space);
        std::vector<double> out;
        double before = position(box).z;
        for (int i = 0; i < steps; ++i) {
            if (!by_world) dJointGroupEmpty(sim.contacts), sim.collide();
            const int made = way == Way::kHybrid ? dWorldStepHybrid(sim.world, real(kH)) : sim.advance(kH);
            EXPECT_EQ(made, 1);
            out.push_back(position(box).z - before);
            before = position(box).z;
        }
        return out;
    }
};

// In 0.1 s at 1 m/s a third of the depth is gone; ERP and the springs of contacts ask for more all the while.
TEST_P(CorrectingVelocity, bounds_how_fast_bodies_are_moved_apart)
{
    for (const double bound : {0.2, 1.0}) {
        const std::vector<double> rise = rises(bound, 20);
        for (const double step : rise) EXPECT_LE(step, bound * kH * (1 + 1e-3) + 1e-6) << bound;
        double sum = 0;
        for (const double step : rise) sum += step;
        EXPECT_GE(sum, 0.7 * bound * 20 * kH) << bound;  // springs of substeps give way
    }
    for (const double step : rises(0, 5)) EXPECT_NEAR(step, 0, tol(1e-12, 1e-6));
}

TEST_P(CorrectingVelocity, unset_bounds_nothing)
{
    const std::vector<double> rise = rises(double(dInfinity), 5);
    EXPECT_GT(*std::max_element(rise.begin(), rise.end()), 1.9 * kH);
}

INSTANTIATE_TEST_SUITE_P(ways, CorrectingVelocity,
                         testing::Combine(testing::Values(Way::kExact, Way::kProjected, Way::kQuick,
                                                          Way::kFast, Way::kHybrid),
                                          testing::Bool()),
                         [](const auto& at) {
                             return std::string(kNames[int(std::get<0>(at.param))]) +
                                    (std::get<1>(at.param) ? "_world" : "_joints");
                         });

}  // namespace
}  // namespace epode::physics
