// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S8b: rays through a cloud of 8,000 boxes. Size: rays.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int count)
{
    constexpr int kAcross = 20;
    constexpr double kPitch = 3, kHalf = 0.5 * kAcross * kPitch;
    const int cube = add_shape(scene, box({1, 1, 1}));
    Lcg random(9);
    const auto place = [&](int cell) { return kPitch * (cell + 0.5) - kHalf + random.uniform(-1, 1); };
    for (int n = 0; n < kAcross * kAcross * kAcross; ++n) {
        const double x = place(n % kAcross), y = place(n / kAcross % kAcross);
        const double z = place(n / (kAcross * kAcross));
        add_static(scene, cube, {x, y, z}, random.any_turn());
    }
    scene.task = Task::kRays;
    const auto anywhere = [&] {
        const double x = random.uniform(-kHalf, kHalf), y = random.uniform(-kHalf, kHalf);
        return Vec{x, y, random.uniform(-kHalf, kHalf)};
    };
    for (int n = 0; n < count; ++n) {
        const Vec from = anywhere();
        scene.rays.push_back({from, anywhere()});
    }
}

}  // namespace

extern const SceneRecipe kBoxRayScene = {"rays at 8,000 boxes", build, {{"S8b", 2000, 20, 500, 2, 300}}};

}  // namespace epode::bench
