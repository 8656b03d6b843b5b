// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A wrecking ball: links of 0.3 m and 1 kg, let go level, with a ball up to a hundred thousand times as heavy at their end. Loaded
// links swing faster than a step can follow (step/island/positions/tension.cpp), and chains used to fly apart within a second, as ODE's do.
// A chain does not become longer, joints do no work, so no energy is gained, and the ball reaches its lowest point when a pendulum
// does.
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kLink = 0.3;

class WreckingBall {
  public:
    WreckingBall(Stepper stepper, int links, double ratio, bool hinges) : sim(stepper), reach_(links * kLink)
    {
        sim.gravity(0, 0, -kG);
        dWorldSetCFM(sim.world, 0);  // ODE's softness in floats, 1e-5 m/N, is more than such loads allow
        for (int i = 0; i < links; ++i) add_link(i, hinges);
        // Its centre is in the last joint, so that a light chain leaves a simple pendulum.
        dMass mass;
        dMassSetSphereTotal(&mass, real(ratio), real(kLink));
        ball_ = sim.body({reach_, 0, 0});
        dBodySetMass(ball_, &mass);
        join(ball_, sim.bodies[sim.bodies.size() - 2], reach_, hinges);
        weight_ = kG * reach_ * (ratio + links / 2.0);
        begin_ = energy(sim);
    }

    double stretch() const { return length(position(ball_)) / reach_ - 1; }
    double gain() const { return (energy(sim) - begin_) / weight_; }
    bool is_past_lowest() const { return position(ball_).x < 0; }
    // K(sin 45 degrees) sqrt(L/g).
    double time_to_lowest() const { return 1.8540746773 * std::sqrt(reach_ / kG); }

    Sim sim;

  private:
    void join(dBodyID body, dBodyID before, double x, bool hinge)
    {
        const dJointID joint =
            hinge ? dJointCreateHinge(sim.world, nullptr) : dJointCreateBall(sim.world, nullptr);
        dJointAttach(joint, body, before);
        if (hinge) {
            dJointSetHingeAnchor(joint, real(x), 0, 0);
            dJointSetHingeAxis(joint, 0, 1, 0);
        } else {
            dJointSetBallAnchor(joint, real(x), 0, 0);
        }
    }

    void add_link(int i, bool hinge)
    {
        dMass mass;
        dMassSetCapsuleTotal(&mass, 1, 1, real(0.02), real(0.26));
        const dBodyID before = sim.bodies.empty() ? nullptr : sim.bodies.back();
        const dBodyID body = sim.body({kLink * (i + 0.5), 0, 0});
        dBodySetMass(body, &mass);
        join(body, before, kLink * i, hinge);
    }

    double reach_, weight_ = 0, begin_ = 0;
    dBodyID ball_ = nullptr;
};

struct Fall {
    double stretch = 0, gain = 0, lowest = 0;
};

Fall fall(WreckingBall& scene, double h, bool hybrid)
{
    Fall seen;
    for (double t = 0; t < 10; t += h) {
        hybrid ? dWorldStepHybrid(scene.sim.world, real(h)) : scene.sim.advance(h);
        seen.stretch = std::max(seen.stretch, scene.stretch());
        seen.gain = std::max(seen.gain, scene.gain());
        if (seen.lowest == 0 && scene.is_past_lowest()) seen.lowest = t / scene.time_to_lowest();
    }
    return seen;
}

using Case = std::tuple<int, double, bool, bool>;  // links, ratio, hinges, hybrid

class HeavyLoad : public testing::TestWithParam<Case> {};

TEST_P(HeavyLoad, swings_on_a_light_chain)
{
    const auto [links, ratio, hinges, hybrid] = GetParam();
    for (const double rate : {60.0, 240.0}) {
        SCOPED_TRACE(rate);
        WreckingBall scene(Stepper::kExact, links, ratio, hinges);
        const Fall seen = fall(scene, 1 / rate, hybrid);
        EXPECT_LT(seen.stretch, hybrid || rate > 100 ? 0.005 : 0.04);
        EXPECT_LT(seen.gain, 0.01);
        EXPECT_NEAR(seen.lowest, 1, 0.05);
    }
}

INSTANTIATE_TEST_SUITE_P(exact, HeavyLoad,
                         testing::Combine(testing::Values(3, 10),
                                          testing::Values(100.0, 1e3, 1e4, kSingle ? 5e3 : 1e5),
                                          testing::Bool(), testing::Bool()));

// Sweeps stretch it, but do not tear it.
TEST(HeavyLoad, does_not_tear_a_chain_in_sweeps)
{
    WreckingBall scene(Stepper::kQuick, 10, 100, false);
    const Fall seen = fall(scene, 1.0 / 60, false);
    EXPECT_LT(seen.stretch, 0.3);
    EXPECT_LT(seen.gain, 0.01);
}

}  // namespace
}  // namespace epode::physics
