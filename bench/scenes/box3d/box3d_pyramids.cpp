// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pyramids of Box3D's benchmarks: cubes of 1 m and 100 kg that touch from the start; one of base 100, or
// a field of pyramids of base 10. Sizes: base, pyramids along an edge of the field.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void add_pyramid(SceneData& scene, int cube, int base, Vec corner)
{
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            const Vec at = corner + Vec{0.5 * (row + 1) + i, 0, 0.5 + row};
            const int body = add_body(scene, cube, at, {}, 100);
            scene.bodies[size_t(body)].rest = at;
        }
    }
}

void build_large(SceneData& scene, int base)
{
    scene.gravity = 10;
    add_floor(scene, 400);
    add_pyramid(scene, add_shape(scene, box({1, 1, 1})), base, {-0.5 * base, 0, 0});
}

void build_many(SceneData& scene, int across)
{
    constexpr int kBase = 10;
    const double half = 0.5 * across * (kBase + 1);
    scene.gravity = 10;
    add_floor(scene, half + 2);
    const int cube = add_shape(scene, box({1, 1, 1}));
    for (int row = 0; row < across; ++row) {
        for (int column = 0; column < across; ++column) {
            const double x = -half + column * (kBase + 1) + 0.5;
            const double y = across > 1 ? -half + 1 + row * 2 * (half - 1) / (across - 1) : 0;
            add_pyramid(scene, cube, kBase, {x, y, 0});
        }
    }
}

}  // namespace

extern const SceneRecipe kLargePyramidScene = {
    "Box3D's large pyramid", build_large, {{"large-pyramid", 100, 200, 15, 60}}};
extern const SceneRecipe kManyPyramidScene = {
    "Box3D's field of pyramids", build_many, {{"many-pyramids", 14, 100, 3, 30}}};

}  // namespace epode::bench
