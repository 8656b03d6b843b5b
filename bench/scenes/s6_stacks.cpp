// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S6: separate stacks of five boxes, on a square grid. Size: stacks.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int count)
{
    constexpr int kBoxes = 5;
    int across = 1;
    while (across * across < count) ++across;
    add_floor(scene, 2.0 * across);
    const int cube = add_shape(scene, box({1, 1, 1}));
    for (int n = 0; n < count; ++n) {
        const double x = 3 * (n % across - 0.5 * (across - 1)), y = 3 * (n / across - 0.5 * (across - 1));
        for (int k = 0; k < kBoxes; ++k) {
            const int body = add_body(scene, cube, {x, y, 0.5 + 1.01 * k});
            scene.bodies[size_t(body)].rest = Vec{x, y, 0.5 + k};
        }
    }
}

}  // namespace

extern const SceneRecipe kStackScene = {"stacks of five boxes", build, {{"S6", 2000, 120, 100, 60, 6}}};

}  // namespace epode::bench
