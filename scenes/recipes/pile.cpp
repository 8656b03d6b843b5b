// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pile: 1,000 spheres, boxes, capsules and cylinders of mixed size and attitude, poured loose into a pit.
// Every pair of shapes meets every other, in contacts that nobody arranged. Positions come from the scene's
// own generator and seed, so two libraries pour the same pile.
#include "scenes/build.h"

namespace epode::scenes {

namespace {

constexpr int kAcross = 8;
constexpr int kCount = 1000;

void add_one(Scene& scene, Lcg& random, Vec pos)
{
    const double size = random.uniform(0.3, 0.5), slim = random.uniform(0.35, 0.6), density = 1000;
    const Turn q = random.any_turn();
    switch (random.below(4)) {
        case 0:
            add_sphere(scene, 0.5 * size, density, pos);
            break;
        case 1:
            add_box(scene, {size, slim * size, random.uniform(0.3, 1) * size}, density, pos, q);
            break;
        case 2:
            add_capsule(scene, 0.35 * slim * size, 0.6 * size, density, pos, q);
            break;
        default:
            add_cylinder(scene, 0.5 * slim * size, size, density, pos, q);
            break;
    }
}

void build(Scene& scene)
{
    Lcg random(scene.seed());
    const double pitch = 0.72, half = 2.9;
    add_ground(scene);
    add_pit(scene, half, half, 2.0);
    for (int i = 0; i < kCount; ++i) {
        const int column = i % kAcross, row = i / kAcross % kAcross, layer = i / (kAcross * kAcross);
        const Vec grid{(column - 0.5 * (kAcross - 1)) * pitch, (row - 0.5 * (kAcross - 1)) * pitch,
                       0.8 + layer * pitch};
        add_one(scene, random, grid + Vec{random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08), 0});
    }
    dWorldSetContactSurfaceLayer(scene.world(), dReal(0.001));
    dWorldSetContactMaxCorrectingVel(scene.world(), 5);
    set_view(scene, {-5.5, -7.0, 8.2}, {0.05, 0.25, 0.6});
}

}  // namespace

extern const Recipe kPile = {
    .name = "pile",
    .description = "1,000 mixed spheres, boxes, capsules and cylinders poured into a pit",
    .dt = 0.005,
    .seconds = 4,
    .stepper = Stepper::kQuick,
    .build = build,
};

}  // namespace epode::scenes
