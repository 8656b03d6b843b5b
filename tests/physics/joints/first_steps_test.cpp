// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// In its first steps a structure's joints carry what they will carry for ever, and no more: limits between the
// two must not break them.
#include <functional>

#include "structures.h"

namespace epode::physics {
namespace {

using Build = std::function<void(Structure&)>;
struct Named {
    const char* name;
    Build build;
};
const Named kStructures[] = {{"wall", [](Structure& s) { build_wall(s, 12, 20); }},
                             {"small wall", [](Structure& s) { build_wall(s, 4, 5); }},
                             {"bridge", [](Structure& s) { build_bridge(s, 12); }},
                             {"long bridge", [](Structure& s) { build_bridge(s, 30); }},
                             {"hanging bridge", [](Structure& s) { build_hanging_bridge(s, 12); }},
                             {"crane", [](Structure& s) { build_crane(s); }}};

struct Preset {
    int defaults;
    double h;
    int (*step)(dWorldID, dReal);
    const char* name;
};
const Preset kPresets[] = {{dDefaultsGame, 1.0 / 60, dWorldStepHybrid, "game"},
                           {dDefaultsGame, 1.0 / 120, dWorldStepHybrid, "game"},
                           {dDefaultsRobot, 1.0 / 240, dWorldStepHybrid, "robot"},
                           {dDefaultsOde, 1.0 / 100, dWorldStep, "ode"},
                           {dDefaultsOde, 1.0 / 100, dWorldStepHybrid, "ode, hybrid"}};

TEST(FirstSteps, load_joints_with_what_they_will_carry)
{
    for (const Preset& preset : kPresets)
        for (const Named& structure : kStructures) {
            Structure s;
            dWorldUseDefaults(s.world, preset.defaults);
            dWorldSetContactSpace(s.world, s.space);
            s.ground();
            structure.build(s);
            double largest = 0;
            for (int i = 0; i < 240; ++i) {
                ASSERT_EQ(preset.step(s.world, real(preset.h)), 1);
                if (i < 60) largest = std::max(largest, s.largest_force());
            }
            EXPECT_LE(largest, 1.05 * s.largest_force()) << preset.name << ", " << structure.name;
        }
}

// The load of the wall's joints is 7.4 kN.
TEST(FirstSteps, break_nothing_that_holds_the_load)
{
    Structure s;
    dWorldUseDefaults(s.world, dDefaultsGame);
    dWorldSetContactSpace(s.world, s.space);
    s.ground();
    build_wall(s, 12, 20);
    for (dJointID j : s.joints) ASSERT_EQ(dJointSetBreakLimits(j, 8000, 0), 1);
    for (int i = 0; i < 120; ++i) ASSERT_EQ(dWorldStepHybrid(s.world, real(1.0 / 60)), 1);
    EXPECT_EQ(dWorldGetBrokenJoints(s.world, nullptr, 0), 0);
    for (dJointID j : s.joints) EXPECT_EQ(dJointIsBroken(j), 0);
    EXPECT_LT(s.fastest(), 1e-2);
}

}  // namespace
}  // namespace epode::physics
