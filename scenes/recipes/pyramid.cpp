// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pyramid: 15 rows of boxes, 120 in all, each standing on two below, one box thick. It should stand for
// ever; creep and sway show how much error a stepper leaves each step, since the weight of 14 rows goes
// through every box of the lowest.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kRows = 15;

void build(Scene& scene)
{
    const Vec size{0.6, 0.4, 0.4};
    const double pitch = 0.64, density = 800;
    add_ground(scene);
    for (int row = 0; row < kRows; ++row) {
        const int count = kRows - row;
        for (int i = 0; i < count; ++i) {
            add_box(scene, size, density, {(i - 0.5 * (count - 1)) * pitch, 0, (row + 0.5) * size.z});
        }
    }
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    scene.tracked = {scene.bodies().back()};
    set_view(scene, {-5.5, -13.5, 5.2}, {0, 0, 2.5});
}

}  // namespace

extern const Recipe kPyramid = {
    .name = "pyramid",
    .description = "120 boxes in 15 rows, one box thick, which should stand for ever",
    .dt = 0.01,
    .seconds = 5,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
