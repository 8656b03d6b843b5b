// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Why it goes wrong: the causes that a running scene has found, or that a recording has kept. A click on one picks
// the body that is to blame.
#include <imgui.h>

#include "scenes/extensions.h"
#include "view/app.h"

namespace epode::view {

namespace {

ImVec4 color_of(int severity)
{
    const ImVec4 kColors[] = {{0.65f, 0.70f, 0.75f, 1}, {1, 0.80f, 0.30f, 1}, {1, 0.45f, 0.35f, 1}};
    return kColors[severity];
}

// Recordings have the words alone, which begin with the severity and end with the body.
scenes::Cause parsed(const std::string& text)
{
    scenes::Cause cause;
    cause.text = text;
    cause.severity = text.starts_with("error") ? 2 : text.starts_with("warning") ? 1 : 0;
    const size_t at = text.rfind("[body ");
    if (at != std::string::npos) cause.body = std::int32_t(std::strtol(text.c_str() + at + 6, nullptr, 10));
    return cause;
}

std::vector<scenes::Cause> recorded(const record::Info& about)
{
    std::vector<scenes::Cause> causes;
    for (int i = 1;; ++i) {
        const auto found = about.find(record::kDiagnosisKey + std::to_string(i));
        if (found == about.end()) return causes;
        causes.push_back(parsed(found->second));
    }
}

// True: it has been clicked.
bool put(const scenes::Cause& cause)
{
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(cause.severity));
    ImGui::TextWrapped("%s", cause.text.c_str());
    ImGui::PopStyleColor();
    if (cause.body < 0) return false;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("a click picks body %d", cause.body);
    return ImGui::IsItemClicked();
}

}  // namespace

void App::pick_body(std::int32_t body)
{
    const Moment now = session_->moment();
    if (body < 0 || size_t(body) >= now.bodies.size()) return;
    for (const Moment::PlacedGeom& geom : now.geoms)
        if (geom.body == body) {
            picked_ = body, picked_geom_ = geom.number, picked_local_ = {};
            return;
        }
}

void App::diagnosis_panel()
{
    if (!ImGui::CollapsingHeader("Diagnosis", ImGuiTreeNodeFlags_DefaultOpen)) return;
    Live* live = session_->live();
    if (live) ImGui::Checkbox("look for causes of failure", &live->options.diagnose);
    const auto causes = live ? live->causes() : recorded(session_->stage().about());
    if (causes.empty() && (!live || live->options.diagnose)) ImGui::TextDisabled("nothing found");
    for (const scenes::Cause& cause : causes)
        if (put(cause)) pick_body(cause.body);
}

}  // namespace epode::view
