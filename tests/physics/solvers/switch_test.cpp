// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Forces persist, whatever the method, the number of substeps, the size of the step or the rows that a joint
// has: a structure at rest hardly feels the change of any of these. What is left is the sag that sweeps leave and
// that depends on their number: the bounds are of its ringing, a tenth or less of what impulses in wrong units
// give. And one that shakes is not shaken harder by a step that changes them by itself.
#include <functional>

#include "structures.h"

namespace epode::physics {
namespace {

struct Step {
    int stepper;  // of dStepper
    int substeps;
    double h;
};

void make(Structure& s, const Step& how, int count = 1)
{
    dWorldSetHybridStepper(s.world, how.stepper);
    dWorldSetHybridSubsteps(s.world, how.substeps);
    for (int i = 0; i < count; ++i) {
        if (!dWorldGetContactSpace(s.world)) s.collide();
        ASSERT_EQ(dWorldStepHybrid(s.world, real(how.h)), 1);
    }
}

constexpr Step kExactly{dStepperExact, 1, 1.0 / 60};
const std::vector<Step> kStepsInTurn = {{dStepperSubsteps, 4, 1.0 / 60},
                                        {dStepperSubsteps, 16, 1.0 / 60},
                                        {dStepperSubsteps, 4, 1.0 / 60},
                                        {dStepperSubsteps, 4, 1.0 / 120},
                                        {dStepperSubstepsExactJoints, 4, 1.0 / 60},
                                        {dStepperSubsteps, 2, 1.0 / 60},
                                        {dStepperSubsteps, 4, 1.0 / 240},
                                        {dStepperSubsteps, 8, 1.0 / 30},
                                        {dStepperSubsteps, 4, 1.0 / 100},
                                        {dStepperSubstepsExactJoints, 16, 1.0 / 60},
                                        {dStepperSubstepsExactJoints, 2, 1.0 / 30},
                                        {dStepperSubsteps, 16, 1.0 / 240}};

struct Jump {
    double force = 0;     // the largest change of a joint's force from step to step, of the largest force
    double velocity = 0;  // m/s
};

Jump switch_through(Structure& s, const std::vector<Step>& steps, int each)
{
    make(s, kExactly, 60);
    Jump jump;
    for (const Step& how : steps)
        for (int i = 0; i < each; ++i) {
            const std::vector<V3> before = s.forces();
            const double scale = s.largest_force();
            make(s, how);
            for (std::size_t k = 0; k < before.size(); ++k)
                jump.force = std::max(jump.force, length(s.forces()[k] - before[k]) / scale);
            jump.velocity = std::max(jump.velocity, s.fastest());
        }
    return jump;
}

void expect_rest(const std::function<void(Structure&)>& build, double force, double velocity,
                 const std::vector<Step>& steps = kStepsInTurn)
{
    Structure s;
    build(s);
    const Jump jump = switch_through(s, steps, 8);
    EXPECT_LT(jump.force, force);
    EXPECT_LT(jump.velocity, velocity);
}

TEST(Switch, a_wall_does_not_feel_it)
{
    expect_rest([](Structure& s) { build_wall(s, 6, 8); }, 0.03, 3e-3);
}
TEST(Switch, a_bridge_does_not_feel_it)
{
    expect_rest([](Structure& s) { build_bridge(s, 12); }, 0.15, 0.04);
}
TEST(Switch, a_long_bridge_does_not_feel_it)
{
    expect_rest([](Structure& s) { build_bridge(s, 30); }, 0.15, 0.04);
}
TEST(Switch, a_hanging_bridge_does_not_feel_it)
{
    expect_rest([](Structure& s) { build_hanging_bridge(s, 12); }, 0.03, 0.012);
}
TEST(Switch, a_crane_does_not_feel_it)
{
    expect_rest([](Structure& s) { build_crane(s); }, 0.05, 0.015);
}

TEST(Switch, frames_of_changing_length_are_not_felt)
{
    Structure s;
    build_wall(s, 6, 8);
    make(s, kExactly, 60);
    const double still = s.largest_force();
    Random random(7);
    for (int i = 0; i < 600; ++i) {
        make(s, {dStepperSubsteps, 4, random.uniform(1.0 / 240, 1.0 / 30)});
        ASSERT_NEAR(s.largest_force(), still, 0.05 * still) << i;
        ASSERT_LT(s.fastest(), 8e-3) << i;
    }
}

// A stop that begins to act, or a motor, takes a row that was not there: the others keep their forces.
TEST(Switch, a_row_that_comes_or_goes_takes_nothing_from_the_others)
{
    for (const int stepper : {int(dStepperSubsteps), int(dStepperSubstepsExactJoints)}) {
        Structure s;
        build_hanging_bridge(s, 12);
        make(s, kExactly, 60);
        const Step how{stepper, 4, 1.0 / 60};
        make(s, how, 20);
        const double still = s.largest_force();
        for (int i = 0; i < 40; ++i) {
            dJointSetHingeParam(s.joints[6], dParamFMax, i % 2 ? 0 : real(1e-6));
            make(s, how);
            ASSERT_NEAR(s.largest_force(), still, 0.02 * still) << i;
            ASSERT_LT(s.fastest(), 2e-3) << i;
        }
    }
}

// ---- what a step changes by itself

struct Hit {
    double force = 0, speed = 0;  // the largest after half a second
    double jump = 0;              // of the largest force, from step to step
    double lean = 0;              // m, of the bricks' centres out of the wall's plane
    int broken = 0;
};

// A wall of the game preset; a ball of 200 kg at 20 m/s hits it.
Hit hit_wall(bool sleeps, double h, bool hybrid, double limit = 0, double seconds = 5)
{
    Structure s;
    dWorldUseDefaults(s.world, dDefaultsGame);
    dWorldSetStepThreads(s.world, 1);
    dWorldSetAutoDisableFlag(s.world, sleeps);
    dWorldSetContactSpace(s.world, s.space);
    s.ground();
    build_wall(s, 12, 20);
    if (limit > 0) {
        for (dJointID j : s.joints) EXPECT_EQ(dJointSetBreakLimits(j, real(limit), 0), 1);
    }
    Hit hit;
    const int begin = int(2 / h), calm = int(2.8 / h), end = int(seconds / h);
    double before = 0;
    for (int i = 0; i < end; ++i) {
        if (i == begin) {
            const dBodyID ball = s.sphere({5, -5, 1.5}, 0.4, 200);
            velocity(ball, {0, 20, 1});
        }
        EXPECT_EQ(hybrid ? dWorldStepHybrid(s.world, real(h)) : dWorldStepFast1(s.world, real(h), 4), 1);
        const double force = s.largest_force();
        if (i > calm) {
            hit.force = std::max(hit.force, force), hit.jump = std::max(hit.jump, force / before);
            for (std::size_t k = 0; k < 240; ++k) {
                hit.speed = std::max(hit.speed, length(velocity(s.bodies[k])));
                hit.lean = std::max(hit.lean, std::abs(position(s.bodies[k]).y));
            }
        }
        before = force;
    }
    for (dJointID j : s.joints) hit.broken += dJointIsBroken(j);
    return hit;
}

TEST(Switch, a_wall_that_has_been_hit_shakes_as_if_nothing_slept)
{
    for (const double h : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
        const Hit awake = hit_wall(false, h, true), sleepy = hit_wall(true, h, true);
        EXPECT_LT(awake.jump, 1.3) << h;
        EXPECT_LT(sleepy.jump, 1.3) << h;
        EXPECT_LT(awake.force, 13e3) << h;  // at rest the joints carry 7.4 kN
        EXPECT_LT(sleepy.force, 1.2 * awake.force) << h;
        // Exact joints, with which it settles, damp a wobble less than sweeps do.
        EXPECT_LT(sleepy.speed, 2 * awake.speed) << h;
    }
    const Hit substeps = hit_wall(true, 1.0 / 60, false);
    EXPECT_LT(substeps.force, 13e3);
    EXPECT_LT(substeps.jump, 1.3);
}

// Sweeps of four substeps held it less firmly than its weight pressed: once out of its plane it leaned further,
// like jelly, and after 9 s hung 2.4 m aside.
TEST(Switch, a_wall_that_has_been_hit_stands_upright_again)
{
    for (const bool sleeps : {true, false})
        for (const bool hybrid : {true, false}) {
            const Hit hit = hit_wall(sleeps, 1.0 / 60, hybrid, 0, 12);
            EXPECT_LT(hit.lean, 0.2) << sleeps << hybrid;
            EXPECT_LT(hit.force, 11e3) << sleeps << hybrid;
            EXPECT_LT(hit.speed, 1.5) << sleeps << hybrid;
        }
}

TEST(Switch, a_wall_that_has_been_hit_keeps_its_joints)
{
    EXPECT_EQ(hit_wall(true, 1.0 / 60, true, 40e3).broken, hit_wall(false, 1.0 / 60, true, 40e3).broken);
    EXPECT_EQ(hit_wall(true, 1.0 / 60, true, 40e3).broken, 0);
}

}  // namespace
}  // namespace epode::physics
