// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// `epode run`: one scene, one stepper, one report. Exit codes as everywhere in the program: 0 fine, 1 a
// problem was found (a state that is not finite, a failed step, a file that cannot be written), 2 wrong
// usage.
#pragma once

#include <cstdint>
#include <string>

namespace epode::cli {

enum ExitCode { kFine = 0, kProblem = 1, kUsage = 2 };

struct RunOptions {
    std::string scene;
    std::string stepper;  // empty: the scene's own
    double dt = 0;        // 0: the scene's own
    int steps = 0;        // 0: by seconds
    double seconds = 0;   // 0: the scene's own
    int iterations = 0;   // 0: the stepper's own
    std::uint32_t seed = 1;
    bool json = false;
    bool quiet = false;
    std::string picture;
    std::string trace;
};

int run(const RunOptions& options);
int list_scenes();

}  // namespace epode::cli
