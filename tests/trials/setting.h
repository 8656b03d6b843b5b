// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A setting is a way to simulate a scene: a method (parameters of the world, where contacts come from, which step
// function), a step size, and whether bodies may fall asleep. The columns of docs/quality.md are methods.
#pragma once

#include <string>
#include <vector>

namespace epode::trials {

enum class Method {
    kOdeExact,  // dDefaultsOde, contact joints made in a near callback, dWorldStep
    kOdeQuick,  // the same with dWorldQuickStep
    kExact,     // dDefaultsOde, world-managed contacts, dWorldStep
    kQuick,     // ... dWorldQuickStep
    kSubsteps,  // ... dWorldStepFast1 with 4 substeps
    kGame,      // dDefaultsGame, world-managed contacts, dWorldStepHybrid
    kRobot      // dDefaultsRobot, the same
};
constexpr Method kMethods[] = {Method::kOdeExact, Method::kOdeQuick, Method::kExact, Method::kQuick,
                               Method::kSubsteps, Method::kGame,     Method::kRobot};
constexpr int kMethodCount = 7;
constexpr double kStepSizes[] = {1.0 / 60, 1.0 / 240, 0.001};
constexpr int kStepSizeCount = 3;

const char* name_of(Method method);       // "ode exact"
const char* name_of_step(int step_size);  // "1/60"

struct Setting {
    Method method = Method::kOdeExact;
    int step_size = 0;  // index into kStepSizes
    bool sleep = false;

    double h() const { return kStepSizes[step_size]; }
    bool operator==(const Setting&) const = default;
};
std::string text_of(const Setting& setting);  // "game 1/60 sleep", as setting_named reads it
bool setting_named(const std::string& text, Setting& setting);
std::vector<Setting> all_settings();

// Sets of methods, for laws that some of them cannot keep.
constexpr unsigned set_of(Method method) { return 1u << int(method); }
constexpr unsigned operator|(Method a, Method b) { return set_of(a) | set_of(b); }
constexpr unsigned operator|(unsigned a, Method b) { return a | set_of(b); }
constexpr bool contains(unsigned methods, Method method) { return methods & set_of(method); }
constexpr unsigned kCallback = Method::kOdeExact | Method::kOdeQuick;
constexpr unsigned kSweeps = Method::kOdeQuick | Method::kQuick;
constexpr unsigned kAll = (1u << kMethodCount) - 1;

}  // namespace epode::trials
