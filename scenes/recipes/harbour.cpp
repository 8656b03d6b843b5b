// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Harbour: crates, barrels, balls and buoys of all densities dropped into water, with two boats of boxes among them. A third of them
// sinks to the bottom. A library without fluids drops all of them.
#include "scenes/build.h"
#include "scenes/extensions.h"

namespace epode::scenes {

namespace {

constexpr int kAcross = 7, kCount = 98;
constexpr double kBottom = -2.5;

void add_one(Scene& scene, Lcg& random, int kind, Vec pos)
{
    const double size = random.uniform(0.25, 0.4), density = random.uniform(150, 1300);
    const Turn q = random.any_turn();
    if (kind == 0) add_box(scene, {size, random.uniform(0.7, 1.3) * size, size}, density, pos, q);
    if (kind == 1) add_cylinder(scene, 0.5 * size, size, density, pos, q);
    if (kind == 2) add_sphere(scene, 0.6 * size, density, pos);
    if (kind == 3) add_capsule(scene, 0.4 * size, size, density, pos, q);
}

void add_boat(Scene& scene, Vec pos)
{
    add_box(scene, {2.4, 0.9, 0.4}, 350, pos);
    add_box(scene, {0.6, 0.6, 0.4}, 200, pos + Vec{-0.6, 0, 0.41});
}

void build(Scene& scene)
{
    Lcg random(scene.seed());
    add_water(scene.world());
    add_ground(scene, kBottom);
    add_boat(scene, {-1.5, -3.6, 0.2});
    add_boat(scene, {1.8, 3.6, 0.2});
    for (int i = 0; i < kCount; ++i) {
        const int column = i % kAcross, row = i / kAcross % kAcross, layer = i / (kAcross * kAcross);
        const Vec grid{(column - 0.5 * (kAcross - 1)) * 0.75, (row - 0.5 * (kAcross - 1)) * 0.75,
                       0.5 + layer * 0.7};
        add_one(scene, random, i % 4, grid + Vec{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0});
    }
    set_view(scene, {-6.5, -9.5, 4.5}, {0, 0, -0.6});
}

}  // namespace

extern const Recipe kHarbour = {
    .name = "harbour",
    .description = "crates, barrels, balls and two boats in water",
    .dt = 1.0 / 60,
    .seconds = 10,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
