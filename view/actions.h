// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Everything that can be done by a key, once: the same table makes the menus, the keys and the help, so that
// nothing is found by luck only. Keys are named by what they write ("p", "[", "+") or by their name ("space",
// "right", "tab", "f1", "ctrl+p").
#pragma once

#include <string>
#include <vector>

namespace epode::view {

enum class Action {
    kPause,
    kStep,
    kStepBack,
    kRestart,
    kFaster,
    kSlower,
    kRealTime,
    kStart,
    kEnd,
    kNextScene,
    kPreviousScene,
    kQuit,
    kGeoms,
    kWireframe,
    kAxes,
    kJoints,
    kJointAxes,
    kLimits,
    kContacts,
    kForces,
    kBoxes,
    kShadows,
    kPaint,
    kPanels,
    kHelp,
    kFrame,
    kFollow,
    kShove,
    kShoot,
    kLetGo
};

struct ActionRow {
    Action action;
    const char* menu;
    const char* label;
    std::vector<std::string> keys;  // the first is shown
    bool repeats = false;           // while the key is held
};

const std::vector<ActionRow>& actions();
// Null: no action has that key.
const ActionRow* action_of(const std::string& key);
// All keys that have one, each after a blank.
std::string key_names();
const ActionRow& row_of(Action action);
// As one would write it on the key: "Space", "Ctrl+P".
std::string shown(const std::string& key);

}  // namespace epode::view
