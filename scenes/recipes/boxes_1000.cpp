// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boxes-1000, the benchmark scene: a loose 10 x 10 x 10 grid of unit boxes dropped into a pit, dt 1/60,
// friction 0.6. Layers are shifted and turned a little so that nothing balances by symmetry. It falls, crowds
// and comes to rest: collision and contact rows in one figure. Boxes arrive at up to 10 m/s, 0.17 m a step:
// so deep are contacts in ODE's way, which first sees two boxes when they overlap. The report counts that as
// penetration at impact.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kSide = 10;

void build(Scene& scene)
{
    Lcg random(scene.seed());
    const double pitch = 1.4, half = 7;
    add_ground(scene);
    add_pit(scene, half, half, 7);
    for (int layer = 0; layer < kSide; ++layer) {
        for (int i = 0; i < kSide * kSide; ++i) {
            const Vec grid{(i % kSide - 0.5 * (kSide - 1)) * pitch, (i / kSide - 0.5 * (kSide - 1)) * pitch,
                           1 + layer * pitch};
            const Vec shift{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 0};
            const Turn tilt =
                turn({random.uniform(-1, 1), random.uniform(-1, 1), 1}, random.uniform(-0.2, 0.2));
            add_box(scene, {1, 1, 1}, 1000, grid + shift, tilt);
        }
    }
    set_view(scene, {-17, -21, 23}, {0, 0.6, 3.2});
}

}  // namespace

extern const Recipe kBoxes1000 = {
    .name = "boxes-1000",
    .description = "10 x 10 x 10 unit boxes dropped into a pit; the benchmark scene",
    .dt = 1.0 / 60,
    .seconds = 6,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
