// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S3: spheres, boxes, capsules, cylinders and hulls of 20 points, turned anyhow, dropped into a pit. Size:
// bodies.
#include "bench/scenes/recipe.h"
#include "bench/scenes/words.h"

namespace epode::bench {

namespace {

void build(SceneData& scene, int count)
{
    constexpr double kPitch = 1.3;
    int across = 1;
    while (across * across * across < count) ++across;
    Lcg random(3);
    add_pit(scene, 1.4 * across, 2.8 * across);
    const std::vector<int> shapes = add_mixed_shapes(scene, true, random);
    for (int n = 0; n < count; ++n) {
        const auto place = [&](int cell) { return kPitch * (cell - 0.5 * (across - 1)); };
        const int shape = shapes[size_t(n) % shapes.size()];
        const double x = place(n % across), y = place(n / across % across);
        add_body(scene, shape, {x, y, 1 + kPitch * (n / (across * across))}, random.any_turn());
    }
}

}  // namespace

extern const SceneRecipe kMixedScene = {
    "spheres, boxes, capsules, cylinders and hulls in a pit", build, {{"S3", 4000, 240, 150, 60, 2}}};

}  // namespace epode::bench
