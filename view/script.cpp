// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See script.h. A double click is the four frames that it takes.
#include "view/script.h"

#include <imgui.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace epode::view {

namespace {

int button_named(const std::string& name)
{
    return name == "left" ? 0 : name == "right" ? 1 : name == "middle" ? 2 : -1;
}

}  // namespace

bool Script::add(const std::string& text, std::string& problem)
{
    std::istringstream in(text);
    Line line;
    if (!(in >> line.verb) || line.verb[0] == '#') return true;
    const std::string& verb = line.verb;
    bool good = true;
    if (verb == "key")
        good = bool(in >> line.word) && action_of(line.word);
    else if (verb == "picture")
        good = bool(in >> line.word);
    else if (verb == "down" || verb == "up")
        good = bool(in >> line.word) && button_named(line.word) >= 0;
    else if (verb == "ctrl")
        good = bool(in >> line.word) && (line.word == "on" || line.word == "off");
    else if (verb == "frames" || verb == "wheel")
        good = bool(in >> line.x);
    else if (verb == "move" || verb == "double")
        good = bool(in >> line.x >> line.y);
    else
        good = verb == "print";
    std::string rest;
    if (!good && verb == "key" && !line.word.empty()) {
        problem = "there is no key '" + line.word + "'. Keys:" + key_names();
        return false;
    }
    if (!good || in >> rest) {
        problem = "'" + text + "' is no line of a script";
        return false;
    }
    if (verb != "double") {
        lines_.push_back(line);
        return true;
    }
    lines_.push_back({"move", "", line.x, line.y});
    for (const char* press : {"down", "up", "down", "up"}) lines_.push_back({press, "left"});
    return true;
}

bool Script::parse(const std::string& text, std::string& problem)
{
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!add(line, problem)) return false;
    }
    return true;
}

bool Script::load(const std::string& path, std::string& problem)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        problem = "cannot read the script " + path;
        return false;
    }
    return parse(text.str(), problem);
}

std::string Script::play(App& app)
{
    ImGuiIO& io = ImGui::GetIO();
    if (waits_ > 0) {
        --waits_;
        return {};
    }
    if (ended()) return {};
    const Line& line = lines_[next_++];
    if (line.verb == "key") app.key(line.word);
    if (line.verb == "move") io.MousePos = {float(line.x), float(line.y)};
    if (line.verb == "down" || line.verb == "up") io.MouseDown[button_named(line.word)] = line.verb == "down";
    if (line.verb == "wheel") io.MouseWheel = float(line.x);
    if (line.verb == "ctrl") {
        io.KeyCtrl = line.word == "on";
        io.KeyMods = io.KeyCtrl ? ImGuiKeyModFlags_Ctrl : ImGuiKeyModFlags_None;
    }
    if (line.verb == "frames") waits_ = std::max(0, int(line.x) - 1);
    if (line.verb == "print") std::printf("%s\n", app.summary().c_str());
    return line.verb == "picture" ? line.word : std::string();
}

}  // namespace epode::view
