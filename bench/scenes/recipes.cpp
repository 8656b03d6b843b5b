// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See recipe.h.
#include "bench/scenes/recipe.h"

namespace epode::bench {

#define BENCH_SCENE(name) extern const SceneRecipe name;
#include "bench/scenes/recipes.inc"
#undef BENCH_SCENE

const std::vector<const SceneRecipe*>& scene_recipes()
{
    static const std::vector<const SceneRecipe*> recipes = {
#define BENCH_SCENE(name) &name,
#include "bench/scenes/recipes.inc"
#undef BENCH_SCENE
    };
    return recipes;
}

std::vector<NamedSetting> all_settings()
{
    std::vector<NamedSetting> all;
    for (const SceneRecipe* recipe : scene_recipes()) {
        for (const Setting& setting : recipe->settings) all.push_back({recipe, &setting});
    }
    return all;
}

std::optional<SceneData> make_scene(const SceneChoice& choice)
{
    for (const auto& [recipe, setting] : all_settings()) {
        if (choice.name != setting->name) continue;
        const bool quick = choice.quick && setting->quick_steps > 0;
        SceneData scene;
        scene.name = choice.name;
        scene.size = choice.size > 0 ? choice.size : quick ? setting->quick_size : setting->size;
        scene.steps = choice.steps > 0 ? choice.steps : quick ? setting->quick_steps : setting->steps;
        recipe->build(scene, scene.size);
        return scene;
    }
    return std::nullopt;
}

}  // namespace epode::bench
