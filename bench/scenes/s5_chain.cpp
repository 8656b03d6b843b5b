// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// S5: a swinging chain whose last link weighs a hundred times the others. Size: joints.
#include "bench/scenes/chain.h"
#include "bench/scenes/recipe.h"

namespace epode::bench {

extern const SceneRecipe kChainScene = {"a chain with a heavy end, exact stepper",
                                        [](SceneData& scene, int size) { add_chain(scene, size, 100); },
                                        {{"S5-32", 32, 600, 32, 120},
                                         {"S5-128", 128, 300, 128, 10},
                                         {"S5-512", 512, 5, 0, 0},
                                         {"S5-2048", 2048, 2, 0, 0}}};

}  // namespace epode::bench
