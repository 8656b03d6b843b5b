// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plain keys are what most engines' viewers have; chords with Ctrl are drawstuff's.
#include "view/actions.h"

#include <algorithm>
#include <cctype>

namespace epode::view {

const std::vector<ActionRow>& actions()
{
    static const std::vector<ActionRow> table = {
        {Action::kPause, "Run", "Pause / go on", {"space", "p", "ctrl+p"}},
        {Action::kStep, "Run", "One step", {"right", ".", "ctrl+o"}, true},
        {Action::kStepBack, "Run", "One step back", {"left", ","}, true},
        {Action::kRestart, "Run", "Restart", {"r", "backspace"}},
        {Action::kStart, "Run", "To the first state kept", {"home"}},
        {Action::kEnd, "Run", "To the last state", {"end"}},
        {Action::kFaster, "Run", "Faster", {"+", "="}},
        {Action::kSlower, "Run", "Slower", {"-"}},
        {Action::kRealTime, "Run", "As fast as the clock", {"1"}},
        {Action::kNextScene, "Scene", "Next scene", {"]"}},
        {Action::kPreviousScene, "Scene", "Previous scene", {"["}},
        {Action::kQuit, "Scene", "Quit", {"ctrl+x", "escape"}},
        {Action::kGeoms, "Show", "Geoms", {"g"}},
        {Action::kWireframe, "Show", "Wireframe", {"w", "ctrl+t"}},
        {Action::kContacts, "Show", "Contacts", {"c"}},
        {Action::kForces, "Show", "Forces of contacts", {"f"}},
        {Action::kJoints, "Show", "Joints", {"j"}},
        {Action::kJointAxes, "Show", "Axes of joints", {"k"}},
        {Action::kLimits, "Show", "Limits of joints", {"l"}},
        {Action::kAxes, "Show", "Axes of bodies", {"x"}},
        {Action::kBoxes, "Show", "Bounding boxes", {"b"}},
        {Action::kPaint, "Show", "Colours: body, island, sleep, speed", {"i"}},
        {Action::kShadows, "Show", "Shadows", {"ctrl+s"}},
        {Action::kFrame, "Look", "Look at everything", {"a"}},
        {Action::kFollow, "Look", "Follow the picked body", {"t"}},
        {Action::kShove, "Body", "Push the picked body away", {"s"}},
        {Action::kShoot, "Body", "Shoot a ball from the eye", {"e"}},
        {Action::kLetGo, "Body", "Pick nothing", {"d"}},
        {Action::kPanels, "Window", "Panels", {"tab"}},
        {Action::kHelp, "Window", "Help", {"f1", "h"}},
    };
    return table;
}

const ActionRow* action_of(const std::string& key)
{
    for (const ActionRow& row : actions()) {
        for (const std::string& name : row.keys) {
            if (name == key) return &row;
        }
    }
    return nullptr;
}

std::string key_names()
{
    std::string names;
    for (const ActionRow& row : actions())
        for (const std::string& name : row.keys) names += " " + name;
    return names;
}

const ActionRow& row_of(Action action)
{
    return *std::find_if(actions().begin(), actions().end(),
                         [&](const ActionRow& row) { return row.action == action; });
}

std::string shown(const std::string& key)
{
    std::string text = key;
    for (size_t i = 0; i < text.size(); ++i) {
        if (i == 0 || text[i - 1] == '+') text[i] = char(std::toupper(static_cast<unsigned char>(text[i])));
    }
    return text;
}

}  // namespace epode::view
