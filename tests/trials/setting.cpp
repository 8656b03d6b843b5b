// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "setting.h"

namespace epode::trials {

const char* name_of(Method method)
{
    constexpr const char* kNames[] = {"ode exact", "ode quick", "exact", "quick",
                                      "substeps",  "game",      "robot"};
    return kNames[int(method)];
}

const char* name_of_step(int step_size)
{
    constexpr const char* kNames[] = {"1/60", "1/240", "1 ms"};
    return kNames[step_size];
}

std::string text_of(const Setting& setting)
{
    return std::string(name_of(setting.method)) + " " + name_of_step(setting.step_size) +
           (setting.sleep ? " sleep" : "");
}

bool setting_named(const std::string& text, Setting& setting)
{
    for (const Setting& each : all_settings()) {
        if (text_of(each) == text) {
            setting = each;
            return true;
        }
    }
    return false;
}

std::vector<Setting> all_settings()
{
    std::vector<Setting> settings;
    for (Method method : kMethods)
        for (int step_size = 0; step_size < kStepSizeCount; ++step_size)
            for (bool sleep : {false, true}) settings.push_back({method, step_size, sleep});
    return settings;
}

}  // namespace epode::trials
