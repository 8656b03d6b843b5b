// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S1: a wall of boxes that narrows by one box a row. Rows start 5 cm above one another, so that the pyramid
// first falls into place; then it must stand. Size: boxes in the lowest row.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int base)
{
    constexpr double kPitch = 1.05;
    add_floor(scene, 40 + base);
    const int cube = add_shape(scene, box({1, 1, 1}));
    for (int row = 0; row < base; ++row) {
        for (int i = 0; i < base - row; ++i) {
            const double x = kPitch * (i - 0.5 * (base - row - 1));
            const int body = add_body(scene, cube, {x, 0, 0.5 + kPitch * row});
            scene.bodies[size_t(body)].rest = Vec{x, 0, 0.5 + row};
        }
    }
}

}  // namespace

extern const SceneRecipe kPyramidScene = {"a 2-D pyramid of boxes", build, {{"S1", 30, 600, 12, 60, 6}}};

}  // namespace epode::bench
