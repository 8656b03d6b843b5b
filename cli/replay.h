// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode replay`, `epode diff`, `epode convert`, `epode inspect`: what is done with recordings. Exit codes as
// everywhere: 0 the same or done, 1 different or damaged, 2 wrong usage.
#pragma once

#include <string>

namespace epode::cli {

struct ReplayOptions {
    std::string file, other;  // other: the second recording of diff, the new file of convert
    std::string stepper;      // replay with another one
    int iterations = -1;      // -1: those of the recording
    std::string contacts;     // recorded or found, of a program's run; "": as the stepper wants
    std::string output;       // what a program's run became, as a recording
    bool partial = false;     // take what there is of a recording that breaks off
    bool hashes = false;      // of inspect
    bool json = false, quiet = false;
    double fps = 30;
};

int replay(const ReplayOptions& options);
int diff(const ReplayOptions& options);
int convert(const ReplayOptions& options);
int inspect(const ReplayOptions& options);

}  // namespace epode::cli
