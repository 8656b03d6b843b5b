// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S9: boxes that fly about in a room, mostly apart; only the pairs whose bounding boxes meet are wanted.
// Size: boxes.
#include <cmath>

#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int count)
{
    constexpr double kVolumeOfEach = 50;  // m3
    const int cube = add_shape(scene, box({1, 1, 1}));
    Lcg random(10);
    scene.task = Task::kBroadPhase;
    scene.cube_side = std::cbrt(kVolumeOfEach * count);
    const double half = scene.cube_side / 2;
    for (int n = 0; n < count; ++n) {
        const double x = random.uniform(-half, half), y = random.uniform(-half, half);
        const int body = add_body(scene, cube, {x, y, random.uniform(-half, half)}, random.any_turn());
        const double u = random.uniform(-5, 5), v = random.uniform(-5, 5);
        scene.bodies[size_t(body)].linear = {u, v, random.uniform(-5, 5)};
    }
}

}  // namespace

extern const SceneRecipe kFlightScene = {
    "broad phase of flying boxes", build, {{"S9", 20000, 30, 3000, 20, 8}}};

}  // namespace epode::bench
