// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The list of scenes: scenes.inc expanded twice, once to declare each recipe, once to collect them.
// An explicit list and not self-registration: static libraries drop objects nobody names, and the order stays
// the one that is written down.
#include "scenes/scene.h"

namespace epode::scenes {

#define EPODE_SCENE(recipe) extern const Recipe recipe;
#include "scenes/scenes.inc"
#undef EPODE_SCENE

const std::vector<const Recipe*>& all_recipes()
{
    static const std::vector<const Recipe*> recipes = {
#define EPODE_SCENE(recipe) &recipe,
#include "scenes/scenes.inc"
#undef EPODE_SCENE
    };
    return recipes;
}

namespace {

std::vector<const Recipe*>& added_recipes()
{
    static std::vector<const Recipe*> recipes;
    return recipes;
}

}  // namespace

void add_recipe(const Recipe& recipe) { added_recipes().push_back(&recipe); }

const Recipe* find_recipe(const std::string& name)
{
    for (const Recipe* recipe : added_recipes()) {
        if (name == recipe->name) return recipe;
    }
    for (const Recipe* recipe : all_recipes()) {
        if (name == recipe->name) return recipe;
    }
    return nullptr;
}

std::string scene_names()
{
    std::string names;
    for (const Recipe* recipe : all_recipes()) names += std::string(" ") + recipe->name;
    return names;
}

std::vector<std::string> scene_list()
{
    std::vector<std::string> names;
    for (const Recipe* recipe : all_recipes()) names.emplace_back(recipe->name);
    return names;
}

}  // namespace epode::scenes
