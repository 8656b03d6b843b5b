// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode view`: opens what is to be looked at, in a window, or without one where there is none.
#pragma once

#include <cstdint>
#include <string>

namespace epode::view {

struct ViewOptions {
    std::string what;     // a scene or a recording (.epr)
    std::string stepper;  // empty: the scene's own
    double dt = 0;        // 0: the scene's own
    int iterations = 0;   // 0: the stepper's own
    int threads = 1;
    std::uint32_t seed = 1;
    int width = 1280, height = 800;
    bool paused = false;
    bool diagnose = false;  // a scene looks for causes of failure
    bool headless = false;
    bool status = false;  // a line to standard output whenever summary() has changed
    int frames = 0;       // then it ends; 0: when the window is closed, without a window at once
    std::string picture;  // PNG file of the last frame
    std::string script;   // file of what a user would do, script.h
};

enum ViewResult { kShown = 0, kTrouble = 1, kWrongUse = 2 };

// Messages go to standard error.
int view(const ViewOptions& options);

}  // namespace epode::view
