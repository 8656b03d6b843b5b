// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The list of scenes: scenes.inc expanded twice, once to declare each scene, once to collect them.
#include "trial.h"

#include <algorithm>
#include <stdexcept>

namespace epode::trials {

#define EPODE_TRIAL(scene) extern const Scene scene;
#include "scenes.inc"
#undef EPODE_TRIAL

const std::vector<const Scene*>& all_scenes()
{
    static const std::vector<const Scene*> scenes = {
#define EPODE_TRIAL(scene) &scene,
#include "scenes.inc"
#undef EPODE_TRIAL
    };
    return scenes;
}

const Scene* scene_named(const std::string& name)
{
    for (const Scene* scene : all_scenes())
        if (name == scene->name) return scene;
    return nullptr;
}

bool is_quick(const Scene& scene, const Setting& setting)
{
    constexpr Setting kQuick[] = {{Method::kOdeExact, 0, false},
                                  {Method::kSubsteps, 0, false},
                                  {Method::kGame, 0, true},
                                  {Method::kRobot, 1, false}};
    return !scene.takes_long && std::find(std::begin(kQuick), std::end(kQuick), setting) != std::end(kQuick);
}

const Law* Scene::law(const std::string& wanted) const
{
    for (const Law& law : laws)
        if (wanted == law.name) return &law;
    return nullptr;
}

double Law::kept(const Setting& setting) const
{
    for (const Weaker& each : weaker)
        if (contains(each.methods, setting.method)) return std::max(bound(setting), each.bound(setting));
    return bound(setting);
}

const char* Law::reason(const Setting& setting) const
{
    for (const Weaker& each : weaker)
        if (contains(each.methods, setting.method)) return each.reason;
    return nullptr;
}

void Run::record(const char* law, double value)
{
    if (!scene_.law(law)) throw std::logic_error(std::string(scene_.name) + " has no law " + law);
    if (!std::isfinite(value)) value = HUGE_VAL;
    const auto [at, is_new] = figures_.emplace(law, value);
    if (!is_new) at->second = std::max(at->second, value);
}

}  // namespace epode::trials
