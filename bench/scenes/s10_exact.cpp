// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S10: what the exact stepper is asked: a chain with ball joints, a tower of boxes that stands. Size: rows of
// constraints, 3 a joint and 12 a box (four contacts, each with friction).
#include "bench/scenes/chain.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

namespace {

void build_chain(SceneData& scene, int rows) { add_chain(scene, rows / 3, 1); }

void build_tower(SceneData& scene, int rows)
{
    const int boxes = rows / 12;
    add_floor(scene, 50);
    const int cube = add_shape(scene, box({1, 1, 1}));
    for (int k = 0; k < boxes; ++k) {
        // A thousandth of overlap: every contact is there from the first step on.
        const int body = add_body(scene, cube, {0, 0, 0.499 + 0.999 * k});
        scene.bodies[size_t(body)].rest = Vec{0, 0, 0.5 + k};
    }
    scene.exact = true;
}

}  // namespace

extern const SceneRecipe kExactChainScene = {
    "a chain, exact stepper",
    build_chain,
    {{"S10c-600", 600, 20, 600, 3}, {"S10c-1200", 1200, 5, 0, 0, 100}, {"S10c-2400", 2400, 1, 0, 0, 300}}};
extern const SceneRecipe kExactTowerScene = {
    "a tower of boxes, exact stepper",
    build_tower,
    {{"S10t-600", 600, 10, 600, 1}, {"S10t-1200", 1200, 2, 0, 0, 100}, {"S10t-2400", 2400, 1, 0, 0, 300}}};

}  // namespace epode::bench
