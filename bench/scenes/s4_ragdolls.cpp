// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S4: ragdolls of 11 bodies and 10 joints, in layers of lying ones, dropped into a pit. Size: ragdolls.
#include "bench/scenes/human.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int count)
{
    constexpr int kLayers = 4;
    int across = 1;
    while (across * across * kLayers < count) ++across;
    add_pit(scene, 2.0 * across + 1, 20);
    const HumanShapes shapes = add_human_shapes(scene);
    Lcg random(4);
    const Turn lying = scenes::turn(scenes::kY, scenes::kPi / 2);
    for (int n = 0; n < count; ++n) {
        const auto place = [&](int cell) {
            return 2.0 * (cell - 0.5 * (across - 1)) + random.uniform(-0.1, 0.1);
        };
        const double x = place(n % across), y = place(n / across % across);
        const Turn yaw = scenes::turn(scenes::kZ, random.uniform(-0.3, 0.3));
        add_human(scene, shapes, {{x, y, 0.5 + 0.7 * (n / (across * across))}, yaw * lying, false, 0});
    }
}

}  // namespace

extern const SceneRecipe kRagdollScene = {"ragdolls", build, {{"S4", 400, 300, 16, 60, 2.5}}};

}  // namespace epode::bench
