// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bridge: 24 planks hinged to each other and, at both ends, to the world; crates fall on it. A redundant
// closed loop through the world (all axes parallel) under load, with contacts on joints: the mixture that
// separates joint solvers from contact solvers.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kPlanks = 24;

void build(Scene& scene)
{
    const Vec plank{0.38, 1.6, 0.08};
    const double pitch = 0.4, density = 700, height = 2.2;
    const double left = -0.5 * kPlanks * pitch;
    add_ground(scene);
    for (double side : {-1.0, 1.0}) {
        add_static_box(scene, {1.2, 2, height}, {side * (0.5 * kPlanks * pitch + 0.65), 0, height / 2});
    }
    dBodyID previous = nullptr;
    for (int i = 0; i < kPlanks; ++i) {
        dBodyID next = add_box(scene, plank, density, {left + (i + 0.5) * pitch, 0, height - plank.z / 2});
        add_hinge(scene, next, previous, {left + i * pitch, 0, height - plank.z / 2}, kY);
        previous = next;
    }
    add_hinge(scene, previous, nullptr, {-left, 0, height - plank.z / 2}, kY);
    for (int i = 0; i < 6; ++i) {
        add_box(scene, {0.5, 0.5, 0.5}, 400, {-2.5 + i, (i % 2 ? 0.2 : -0.2), height + 0.8 + 0.3 * i},
                turn(kZ, 0.3 * i));
    }
    scene.tracked = {scene.bodies()[kPlanks / 2]};
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    set_view(scene, {-4.5, -11.5, 4.6}, {0.1, 0, 1.5});
}

}  // namespace

extern const Recipe kBridge = {
    .name = "bridge",
    .description = "24 planks on hinges between two towers, loaded with crates",
    .dt = 0.005,
    .seconds = 4,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
