// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S7, S8m: hills of 131,072 triangles, with mixed solids dropped on them, or rays shot at them. Sizes:
// solids, rays.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

constexpr int kCells = 256;

void build_solids(SceneData& scene, int count)
{
    constexpr double kPitch = 2;
    add_terrain(scene, make_hills(kCells, 1));
    int across = 1;
    while (across * across < count) ++across;
    Lcg random(7);
    const std::vector<int> shapes = add_mixed_shapes(scene, false, random);
    for (int n = 0; n < count; ++n) {
        const auto place = [&](int cell) { return kPitch * (cell - 0.5 * (across - 1)) + 0.3; };
        const double x = place(n % across), y = place(n / across);
        add_body(scene, shapes[size_t(n) % shapes.size()], {x, y, scene.terrain->at(x, y) + 1.5},
                 random.any_turn());
    }
}

void build_rays(SceneData& scene, int count)
{
    const double half = 0.45 * kCells;
    add_terrain(scene, make_hills(kCells, 1));
    scene.task = Task::kRays;
    Lcg random(8);
    for (int n = 0; n < count; ++n) {
        const Vec from{random.uniform(-half, half), random.uniform(-half, half), 20};
        scene.rays.push_back({from, from + Vec{random.uniform(-60, 60), random.uniform(-60, 60), -40}});
    }
}

}  // namespace

extern const SceneRecipe kTerrainScene = {
    "mixed solids on a terrain of 131,072 triangles", build_solids, {{"S7", 2000, 180, 200, 40, 4}}};
extern const SceneRecipe kTerrainRayScene = {
    "rays at the terrain", build_rays, {{"S8m", 20000, 20, 5000, 2, 2}}};

}  // namespace epode::bench
