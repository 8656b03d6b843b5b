// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dominoes: 40 stones along an S-curve, the first one pushed. Impacts travel through the row; each stone is a
// resting contact, a falling body and a pusher in turn. The run is judged at its end: every stone must lie.
#include <cmath>

#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kStones = 40;

void build(Scene& scene)
{
    const Vec stone{0.08, 0.4, 0.8};
    const double density = 900, spacing = 0.32;
    add_ground(scene);
    Vec pos{-5.2, -1.0, stone.z / 2};
    double heading = 0.6;
    for (int i = 0; i < kStones; ++i) {
        add_box(scene, stone, density, pos, turn(kZ, heading));
        heading += 0.05 * std::cos(2 * kPi * i / (kStones - 1) + 1.2);
        pos = pos + spacing * Vec{std::cos(heading), std::sin(heading), 0};
    }
    // Turning about its lower edge: v = w x r with r from that edge to the centre.
    const Vec along{std::cos(0.6), std::sin(0.6), 0}, across{-along.y, along.x, 0};
    const double speed = 2.0;
    set_velocity(scene.bodies().front(), (speed * stone.z / 2) * along, speed * across);

    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    scene.tracked = {scene.bodies().back()};
    set_view(scene, {-4.5, -9, 4.2}, {0.2, 1.2, 0.2});
}

}  // namespace

extern const Recipe kDominoes = {
    .name = "dominoes",
    .description = "40 dominoes along an S-curve, the first one pushed",
    .dt = 0.01,
    .seconds = 8,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
