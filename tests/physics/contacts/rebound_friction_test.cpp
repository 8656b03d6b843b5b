// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Coulomb's law over the whole impulse of a rebound, in every way to step and under the presets, by
// world-managed contacts and by contact joints: a ball that slides all through it gets mu p_n along the floor,
// one that sticks leaves rolling, neither gains energy, and a belt takes along what bounces on it.
#include <tuple>

#include "drive_ways.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

enum class Preset { kNone, kGame, kRobot };

class ReboundFriction : public testing::TestWithParam<std::tuple<Way, Preset, bool>> {
  protected:
    static constexpr double kRadius = 0.1, kMass = 2, kGravity = 9.81;

    struct Rebound {
        double along, normal;     // impulses of the floor, N s
        double slip, spin, gain;  // at the lowest point, m/s; rad/s; of energy, J
    };

    // A ball with this velocity along x, thrown down at 2 m/s from 0.1 m above the floor, until it rises.
    static Rebound bounce(double h, double along, double mu, double bounciness, double belt = 0)
    {
        Sim sim;
        const auto [way, preset, by_world] = GetParam();
        if (preset != Preset::kNone)
            dWorldUseDefaults(sim.world, preset == Preset::kGame ? dDefaultsGame : dDefaultsRobot);
        dWorldSetCFM(sim.world, 0);
        sim.gravity(0, 0, -kGravity);
        set_material(sim.ground(), mu, bounciness, {belt, 0, 0});
        if (by_world) dWorldSetContactSpace(sim.world, sim.space);
        sim.surface.mode = dContactBounce | dContactApprox1;
        sim.surface.mu = real(mu), sim.surface.bounce = real(bounciness), sim.surface.bounce_vel = 0;
        const dBodyID ball = sim.sphere({0, 0, 0.2}, kRadius, kMass);
        set_material(geom_of(ball), mu, bounciness);
        velocity(ball, {along, 0, -2});
        const double before = energy(sim);
        int steps = 0;
        for (; velocity(ball).z <= 0 && steps < 300; ++steps) {
            dJointGroupEmpty(sim.contacts);
            if (!by_world) sim.collide();
            step(sim, way, h);
        }
        const V3 v = velocity(ball);
        return {kMass * (v.x - along), kMass * (v.z + 2 + kGravity * h * steps), v.x - kRadius * spin(ball).y,
                spin(ball).y, energy(sim) - before};
    }
};

constexpr double kStepSizes[] = {1.0 / 60, 1.0 / 240, 0.001};

TEST_P(ReboundFriction, of_what_slides_is_mu_times_the_whole_impulse)
{
    for (const double h : kStepSizes)
        for (const double bounciness : {0.5, 0.8, 1.0}) {
            const Rebound r = bounce(h, 5, 0.1, bounciness);
            EXPECT_NEAR(-r.along / (0.1 * r.normal), 1, 0.02) << "h " << h << ", e " << bounciness;
            EXPECT_GT(r.normal, kMass * 2 * (1 + 0.5 * bounciness)) << "h " << h << ", e " << bounciness;
            EXPECT_NEAR(r.spin, -r.along * kRadius / (0.4 * kMass * kRadius * kRadius), 0.01 * r.spin);
            EXPECT_LT(r.gain, 0);
        }
}

TEST_P(ReboundFriction, of_what_sticks_ends_in_rolling)
{
    for (const double h : kStepSizes) {
        const Rebound r = bounce(h, 1, 1, 0.8);
        EXPECT_NEAR(r.slip, 0, 0.01) << "h " << h;
        EXPECT_NEAR(r.along, -kMass * 2 / 7.0, 0.02) << "h " << h;
        EXPECT_LT(r.gain, 0);
    }
}

TEST_P(ReboundFriction, takes_what_bounces_on_a_belt_along)
{
    if (!std::get<2>(GetParam())) return;  // a belt is a material
    for (const double h : kStepSizes) {
        const Rebound r = bounce(h, 0, 0.1, 0.8, 50);
        EXPECT_NEAR(std::fabs(r.along) / (0.1 * r.normal), 1, 0.02) << "h " << h;
    }
}

std::string case_of(const testing::TestParamInfo<ReboundFriction::ParamType>& info)
{
    constexpr const char* kPresets[] = {"plain", "game", "robot"};
    return std::string(name_of(std::get<0>(info.param))) + "_" + kPresets[int(std::get<1>(info.param))] +
           (std::get<2>(info.param) ? "_managed" : "_joints");
}
INSTANTIATE_TEST_SUITE_P(Ways, ReboundFriction,
                         testing::Combine(testing::ValuesIn(kWays),
                                          testing::Values(Preset::kNone, Preset::kGame, Preset::kRobot),
                                          testing::Bool()),
                         case_of);

}  // namespace
}  // namespace epode::physics
