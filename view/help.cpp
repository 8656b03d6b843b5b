// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// F1: all keys, from the table that makes them.
#include <imgui.h>

#include "view/app.h"

namespace epode::view {

void App::help()
{
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({io.DisplaySize.x * 0.6f, io.DisplaySize.y * 0.5f}, ImGuiCond_Appearing,
                            {0.5f, 0.5f});
    if (!ImGui::Begin("Help", &help_, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        ImGui::End();
        return;
    }
    const char* menu = "";
    for (const ActionRow& action : actions()) {
        if (std::string(menu) != action.menu) {
            menu = action.menu;
            ImGui::TextColored({1, 0.85f, 0.4f, 1}, "%s", menu);
        }
        std::string keys;
        for (const std::string& key : action.keys) keys += (keys.empty() ? "" : "  ") + shown(key);
        ImGui::Text("  %-20s", keys.c_str());
        ImGui::SameLine(190);
        ImGui::TextUnformatted(action.label);
    }
    ImGui::TextColored({1, 0.85f, 0.4f, 1}, "Mouse");
    const char* const mouse[][2] = {{"left drag", "turn"},
                                    {"right, middle drag", "shift"},
                                    {"wheel", "come closer"},
                                    {"double click", "pick"},
                                    {"Ctrl + left drag", "pull a body by a spring"}};
    for (const auto& line : mouse) {
        ImGui::Text("  %s", line[0]);
        ImGui::SameLine(190);
        ImGui::TextUnformatted(line[1]);
    }
    ImGui::End();
}

}  // namespace epode::view
