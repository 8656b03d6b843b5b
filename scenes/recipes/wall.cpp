// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Wall: 10 courses of bricks in running bond, half bricks at the ends, hit by an iron cannon ball of 220 kg
// at 20 m/s. A stack at rest, then an impact, then many small islands: what an iterative solver, its warm
// start and its sleeping see in one run.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kCourses = 10;
constexpr int kBricks = 7;

void build(Scene& scene)
{
    const Vec brick{0.5, 0.25, 0.25};
    const double density = 1800;
    add_ground(scene);
    for (int course = 0; course < kCourses; ++course) {
        const double z = (course + 0.5) * brick.z;
        const bool shifted = course % 2 == 1;
        const double left = -0.5 * kBricks * brick.x;
        for (int i = 0; i < kBricks - (shifted ? 1 : 0); ++i) {
            add_box(scene, brick, density, {left + (i + (shifted ? 1.0 : 0.5)) * brick.x, 0, z});
        }
        if (!shifted) continue;
        const Vec half{brick.x / 2, brick.y, brick.z};
        add_box(scene, half, density, {left + brick.x / 4, 0, z});
        add_box(scene, half, density, {-left - brick.x / 4, 0, z});
    }

    dBodyID ball = add_sphere(scene, 0.19, 7700, {0.15, -9, 1.0});
    set_velocity(ball, {0, 20, 2.0});

    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    scene.tracked = {ball};
    set_view(scene, {-5.6, -5.4, 2.9}, {0, 0.9, 0.95});
}

}  // namespace

extern const Recipe kWall = {
    .name = "wall",
    .description = "a brick wall of 10 courses hit by a cannon ball",
    .dt = 0.005,
    .seconds = 2,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
