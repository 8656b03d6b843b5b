// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the command line and the surroundings ask of a run. Read once, before the window is opened; a number
// or a word that means nothing is named on stderr and taken as not given.
#pragma once

#include <string>

#include "drawstuff/drawstuff.h"

namespace epode::drawstuff {

struct Options {
    bool textures = true;
    bool shadows = true;
    bool paused = false;
    std::string texture_path;  // where pictures for textures lie; empty: our own
    bool headless = false;
    std::string frame_folder = "frame";  // of headless runs; empty: no pictures
    int frame_count = 300;               // 0: no limit
    int frame_every = 1;
    bool fine = false;
};

Options read_options(int argc, const char* const* argv, const dsFunctions& functions);

}  // namespace epode::drawstuff
