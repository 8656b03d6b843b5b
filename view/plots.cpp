// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Figures of the last states up to the one that is shown.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "view/app.h"

namespace epode::view {

namespace {

constexpr size_t kStates = 300;

template <class Get>
void plot(const char* name, const char* format, const Stage& stage, size_t now, Get get)
{
    std::vector<float> values;
    const size_t from = now >= stage.first() + kStates ? now - kStates : stage.first();
    for (size_t i = from; i <= now; ++i) {
        const double value = get(stage.at(i));
        values.push_back(std::isfinite(value) ? float(value) : 0.0f);
    }
    char last[64];
    std::snprintf(last, sizeof last, format, double(values.back()));
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(130);
    ImGui::TextUnformatted(last);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    // A value that does not change stays in the middle, whatever its last bits do.
    const float range = std::max(*high - *low, 1e-6f * std::max(std::abs(*high), 1e-9f));
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(-1);
    ImGui::PlotLines("", values.data(), int(values.size()), 0, nullptr, *low - 0.05f * range,
                     *high + 0.05f * range, {0, 34});
    ImGui::PopID();
}

}  // namespace

void App::plots_panel()
{
    if (!ImGui::CollapsingHeader("Plots", ImGuiTreeNodeFlags_DefaultOpen)) return;
    const Stage& stage = session_->stage();
    const size_t now = session_->now();
    plot("energy", "%.6g J", stage, now, [](const State& s) { return s.step.kinetic + s.step.potential; });
    plot("kinetic", "%.6g J", stage, now, [](const State& s) { return s.step.kinetic; });
    plot("joint error", "%.3g m", stage, now, [](const State& s) { return s.step.joint_error; });
    if (stage.at(now).figures.residual >= 0)
        plot("residual", "%.3g", stage, now,
             [](const State& s) { return std::max(s.figures.residual, 0.0); });
    plot("a step takes", "%.3g ms", stage, now, [](const State& s) { return s.step.ms; });
    if (session_->live()) {
        plot("  collision", "%.3g ms", stage, now, [](const State& s) { return s.figures.collide_ms; });
        plot("  stepper", "%.3g ms", stage, now, [](const State& s) { return s.figures.step_ms; });
        plot("  contacts off", "%.3g ms", stage, now, [](const State& s) { return s.figures.empty_ms; });
    }
}

}  // namespace epode::view
