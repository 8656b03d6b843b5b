// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A heavy crate on a bridge of light planks: the planks hold, and the energy that weight does not give does not come.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr int kPlanks = 40;
constexpr double kPlankMass = 5, kCrateMass = 500;

struct Bridge {
    std::vector<dBodyID> planks;
    std::vector<dJointID> joints;

    explicit Bridge(Stage& stage)
    {
        Vec at{0, 0, 5};
        for (int i = 0; i < kPlanks; ++i) {
            const double slope = 0.42 * (1 - 2 * (i + 0.5) / kPlanks);
            const Vec next = at + Vec{0.5 * std::cos(slope), 0, -0.5 * std::sin(slope)};
            planks.push_back(stage.box({0.46, 2, 0.06}, kPlankMass, 0.5 * (at + next), turn(kY, slope)));
            joints.push_back(stage.hinge(planks.back(), i ? planks[size_t(i) - 1] : nullptr, at, kY));
            at = next;
        }
        joints.push_back(stage.hinge(nullptr, planks.back(), at, kY));
    }
    double worst_gap() const
    {
        double worst = 0;
        for (dJointID joint : joints) worst = std::max(worst, gap(joint));
        return worst;
    }
    double fastest() const
    {
        double fastest = 0;
        for (dBodyID plank : planks) fastest = std::max(fastest, length(velocity(plank)));
        return fastest;
    }
};

void cross(Run& run)
{
    Stage stage(run);
    stage.surface.friction = 0.6;
    const Bridge bridge(stage);
    stage.advance(3);
    const double middle = position(bridge.planks[kPlanks / 2]).z;
    const dBodyID crate = stage.box({1, 1, 1}, kCrateMass, {10 - 0.2, 0, middle + 0.6});
    const double start = energy(stage);
    const int steps = stage.steps_in(6);
    for (int i = 0; i < steps; ++i) {
        stage.step();
        run.record("gap", 1000 * bridge.worst_gap());
        run.record("energy", 100 * (energy(stage) - start) / (kCrateMass * kGravity));
        if (i > steps * 3 / 4) run.record("speed", bridge.fastest());
    }
    run.record("lost", position(crate).z > 1.5 && position(crate).z < middle + 0.7 ? 0 : 1);
}

}  // namespace

extern const Scene kHangingBridge{
    "Joints",
    "hanging_bridge",
    "a crate of 500 kg is put on 40 planks of 5 kg that hang on hinges (game/bridge_exact.c), 6 s",
    {{"gap", "opening of a hinge", "mm", 20},
     {"speed", "speed of the fastest plank in the last second and a half", "m/s", 10},
     {"energy", "gain of energy, of the crate's weight times 1 m", "%", 1},
     {"lost", "crates that did not stay", "1", 0}},
    &cross};

}  // namespace epode::trials
