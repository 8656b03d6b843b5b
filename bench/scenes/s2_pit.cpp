// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S2, S2W: a loose cube of boxes dropped into a pit. Size: boxes along an edge of the cube.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int across)
{
    constexpr double kPitch = 1.3;
    const double side = 1.425 * across;
    add_pit(scene, side, 2 * side);
    const int cube = add_shape(scene, box({1, 1, 1}));
    Lcg random(2);
    for (int k = 0; k < across; ++k) {
        for (int j = 0; j < across; ++j) {
            for (int i = 0; i < across; ++i) {
                const auto place = [&](int cell) {
                    return kPitch * (cell - 0.5 * (across - 1)) + random.uniform(-0.1, 0.1);
                };
                const double x = place(i), y = place(j);
                add_body(scene, cube, {x, y, 1 + kPitch * k});
            }
        }
    }
}

}  // namespace

extern const SceneRecipe kPitScene = {
    "boxes dropped in a pit", build, {{"S2", 10, 360, 5, 60, 6}, {"S2W", 20, 180, 10, 40, 6}}};

}  // namespace epode::bench
