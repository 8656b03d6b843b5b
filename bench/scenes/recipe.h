// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The list of benchmark scenes. A recipe builds its scene in any size; a setting is a size and a length of
// run with a name, as the tables have it. A new scene is one file with a SceneRecipe and one line in
// recipes.inc.
#pragma once

#include "bench/scenes/scene_data.h"

namespace epode::bench {

struct Setting {
    const char* name;
    int size, steps;
    int quick_size, quick_steps;  // 0 steps: no quick run
    double goal = 0;              // ODE's way: times as fast as Debian's libode; 0: no goal
};

struct SceneRecipe {
    const char* about;
    void (*build)(SceneData&, int size);
    std::vector<Setting> settings;
};

struct NamedSetting {
    const SceneRecipe* recipe = nullptr;
    const Setting* setting = nullptr;
};

const std::vector<const SceneRecipe*>& scene_recipes();
std::vector<NamedSetting> all_settings();

// What a setting is changed by: the quick one instead, another size or length where not 0.
struct SceneChoice {
    std::string name;
    bool quick = false;
    int size = 0, steps = 0;
};
// Nothing when there is no setting of that name.
std::optional<SceneData> make_scene(const SceneChoice& choice);

}  // namespace epode::bench
