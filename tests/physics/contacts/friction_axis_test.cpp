// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Friction with an axis: a block slides with mu1 g along it and mu2 g across it, and between them loses what Coulomb's
// ellipse lets it lose most,  a = -g (mu1^2 u1, mu2^2 u2) / sqrt(mu1^2 u1^2 + mu2^2 u2^2). In every stepper and preset,
// in three step sizes. And what a bounded impulse lets through.
#include <array>
#include <string>
#include <tuple>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kAlong = 0.2, kAcross = 0.6, kGravity = 9.81;

enum class AxisStepper { kExact, kExactCone, kQuick, kSubsteps, kGame, kRobot };
constexpr const char* kAxisStepperNames[] = {"exact", "exact_cone", "quick", "substeps", "game", "robot"};

using AxisSetting = std::tuple<AxisStepper, int>;

class FrictionAxis : public testing::TestWithParam<AxisSetting> {
  protected:
    class Floor : public WorldContactsSim {
      public:
        explicit Floor(AxisStepper s) : WorldContactsSim(Stepper::kExact), how(s)
        {
            if (how == AxisStepper::kGame) dWorldUseDefaults(world, dDefaultsGame);
            if (how == AxisStepper::kRobot) dWorldUseDefaults(world, dDefaultsRobot);
            gravity(0, 0, -kGravity);
            dWorldSetAutoDisableFlag(world, 0);
            if (how == AxisStepper::kExactCone) dWorldSetFrictionCone(world, 1);
            plane = ground();
            set_material(plane, 1);
        }
        int go(double h) const
        {
            const dReal step = real(h);
            switch (how) {
                case AxisStepper::kExact:
                case AxisStepper::kExactCone:
                    return dWorldStep(world, step);
                case AxisStepper::kQuick:
                    return dWorldQuickStep(world, step);
                case AxisStepper::kSubsteps:
                    return dWorldStepFast1(world, step, 4);
                default:
                    return dWorldStepHybrid(world, step);
            }
        }
        dBodyID block(double angle)
        {
            const dBodyID body = box({0, 0, 0.1}, {1, 1, 0.2}, 3);
            dMaterial m;
            dMaterialInit(&m, sizeof m);
            m.friction = real(kAlong), m.cross_friction = real(kAcross);
            m.friction_rule = dCombineMinimum;
            m.friction_axis[0] = real(std::cos(angle)), m.friction_axis[1] = real(std::sin(angle));
            EXPECT_EQ(dGeomSetMaterial(geom_of(body), &m), 1);
            return body;
        }
        AxisStepper how;
        dGeomID plane;
    };

    AxisStepper how() const { return std::get<0>(GetParam()); }
    double h() const { return 1.0 / std::get<1>(GetParam()); }
    int steps_in(double seconds) const { return int(std::lround(seconds / h())); }
};

// Velocity along and across the axis after t.
std::array<double, 2> braked(double u1, double u2, double t)
{
    constexpr int kParts = 20000;
    for (int i = 0; i < kParts; ++i) {
        const double a = kAlong * kAlong * u1, b = kAcross * kAcross * u2;
        const double size = std::hypot(kAlong * u1, kAcross * u2);
        if (size < 1e-6) break;
        u1 -= kGravity * a / size * (t / kParts), u2 -= kGravity * b / size * (t / kParts);
    }
    return {u1, u2};
}

TEST_P(FrictionAxis, a_block_slides_with_its_two_coefficients_along_and_across)
{
    for (const double angle : {0.0, 0.5})
        for (const bool along : {true, false}) {
            Floor floor(how());
            const dBodyID block = floor.block(angle);
            for (int i = 0; i < steps_in(0.5); ++i) ASSERT_EQ(floor.go(h()), 1);
            const double way = along ? angle : angle + kPi / 2;
            velocity(block, {3 * std::cos(way), 3 * std::sin(way), 0});
            for (int i = 0; i < steps_in(0.3); ++i) ASSERT_EQ(floor.go(h()), 1);
            const V3 v = vec(dBodyGetLinearVel(block));
            const double forward = v.x * std::cos(way) + v.y * std::sin(way);
            const double mu = along ? kAlong : kAcross;
            EXPECT_NEAR(forward, 3 - mu * kGravity * h() * steps_in(0.3), 0.012) << angle << along;
            EXPECT_NEAR(v.y * std::cos(way) - v.x * std::sin(way), 0, 0.012) << angle << along;
        }
}

TEST_P(FrictionAxis, between_its_axes_a_block_is_braked_by_the_ellipse_at_the_largest_power)
{
    for (const double direction : {0.3, 0.8, 2.2}) {
        constexpr double angle = 0.4;
        Floor floor(how());
        const dBodyID block = floor.block(angle);
        for (int i = 0; i < steps_in(0.5); ++i) ASSERT_EQ(floor.go(h()), 1);
        const double u1 = 3 * std::cos(direction), u2 = 3 * std::sin(direction);
        velocity(block, {u1 * std::cos(angle) - u2 * std::sin(angle),
                         u1 * std::sin(angle) + u2 * std::cos(angle), 0});
        const int steps = steps_in(0.25);
        for (int i = 0; i < steps; ++i) ASSERT_EQ(floor.go(h()), 1);
        const V3 v = vec(dBodyGetLinearVel(block));
        const auto law = braked(u1, u2, steps * h());
        EXPECT_NEAR(v.x * std::cos(angle) + v.y * std::sin(angle), law[0], 0.012 + 2.4 * h()) << direction;
        EXPECT_NEAR(v.y * std::cos(angle) - v.x * std::sin(angle), law[1], 0.012 + 2.4 * h()) << direction;
    }
}

// Pushed sideways with 0.95 and 1.05 times what the ellipse can hold.
TEST_P(FrictionAxis, a_block_sticks_within_the_ellipse_and_slides_beyond)
{
    for (const double load : {0.95, 1.05})
        for (const double direction : {0.0, 1.5707963267948966}) {
            Floor floor(how());
            const dBodyID block = floor.block(0);
            const double mu = direction == 0 ? kAlong : kAcross;
            for (int i = 0; i < steps_in(0.5); ++i) ASSERT_EQ(floor.go(h()), 1);
            floor.gravity(load * mu * kGravity * std::cos(direction),
                          load * mu * kGravity * std::sin(direction), -kGravity);
            for (int i = 0; i < steps_in(0.5); ++i) ASSERT_EQ(floor.go(h()), 1);
            const double speed = length(vec(dBodyGetLinearVel(block)));
            if (load < 1)
                EXPECT_LT(speed, 0.02) << direction;
            else
                EXPECT_NEAR(speed, 0.05 * mu * kGravity * h() * steps_in(0.5), 0.03) << direction;
        }
}

struct Window {
    double max_impulse = 0;
};

void give_way(void* data, dManifold* manifold)
{
    manifold->max_impulse = real(static_cast<Window*>(data)->max_impulse);
}

// A ball that touches with 5 m/s: what a pane can exert is taken from its momentum, and no more.
TEST_P(FrictionAxis, a_pane_takes_its_largest_impulse_from_a_ball_and_no_more)
{
    Floor floor(how());
    floor.gravity(0, 0, 0);
    const dBodyID ball = floor.sphere({0, 0, 0.5}, 0.5, 2);
    velocity(ball, {0, 0, -5});
    Window window{3};
    dWorldSetManifoldFunction(floor.world, give_way, &window, 0);
    ASSERT_EQ(floor.go(h()), 1);
    EXPECT_NEAR(vec(dBodyGetLinearVel(ball)).z, -5 + 3.0 / 2, 1e-4);
    EXPECT_NEAR(floor.all_contacts().at(0).normal_force * h(), 3, 1e-4);
}

// F = J/h on each step; beyond it the block sinks with g - F/m.
TEST_P(FrictionAxis, ground_that_bears_less_than_the_weight_gives_way_with_the_difference)
{
    for (const double share : {0.5, 1.5}) {
        Floor floor(how());
        const dBodyID block = floor.box({0, 0, 0.1}, {1, 1, 0.2}, 3);
        for (int i = 0; i < steps_in(0.5); ++i) ASSERT_EQ(floor.go(h()), 1);
        Window window{share * 3 * kGravity * h()};
        dWorldSetManifoldFunction(floor.world, give_way, &window, 0);
        const int steps = steps_in(0.1);
        for (int i = 0; i < steps; ++i) ASSERT_EQ(floor.go(h()), 1);
        const double v = vec(dBodyGetLinearVel(block)).z;
        if (share < 1)
            EXPECT_NEAR(v, -(1 - share) * kGravity * h() * steps, 0.01);
        else
            EXPECT_NEAR(v, 0, 0.02);
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, FrictionAxis,
                         testing::Combine(testing::Values(AxisStepper::kExact, AxisStepper::kExactCone,
                                                          AxisStepper::kQuick, AxisStepper::kSubsteps,
                                                          AxisStepper::kGame, AxisStepper::kRobot),
                                          testing::Values(60, 120, 240)),
                         [](const auto& one) {
                             return kAxisStepperNames[int(std::get<0>(one.param))] + std::string("_") +
                                    std::to_string(std::get<1>(one.param));
                         });

}  // namespace
}  // namespace epode::physics
