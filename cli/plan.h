// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From what was asked for to what is done: the options of a run, completed by the scene's own values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace epode::cli {

constexpr int kMaxIterations = 100'000, kMaxSubsteps = 10'000;  // what the library takes
constexpr int kMaxThreads = 256;

enum ExitCode { kFine = 0, kProblem = 1, kUsage = 2 };

struct RunOptions {
    std::string scene;
    std::string stepper;  // empty: as recommended for the scene
    // Not of contact joints; also where that is recommended and no stepper named.
    bool world_contacts = false;
    int threads = 1;
    double dt = 0;       // 0: the scene's own
    int steps = 0;       // 0: by seconds
    double seconds = 0;  // 0: the scene's own
    int iterations = 0;  // 0: the stepper's own
    std::uint32_t seed = 1;
    bool json = false;
    bool quiet = false;
    bool diagnose = false;  // report why the run went wrong
    std::string picture;
    std::string trace;
    std::vector<std::string> records;  // their endings decide the formats
    std::string video;
    double fps = 30;  // of pages, .glb files and videos
};

struct RunPlan {
    scenes::Stepper stepper = scenes::Stepper::kQuick;
    bool world_contacts = false;
    bool recommended = false;  // nobody said otherwise
    int threads = 1;
    double dt = 0;
    int steps = 0;
    int iterations = 0;
    std::uint32_t seed = 1;
};

// False and a message on a contradiction or an impossible value.
bool settle(const RunOptions& options, const scenes::Recipe& recipe, RunPlan& plan, std::string& problem);
// The message where there is no such scene: it names those there are.
std::string no_such_scene(const std::string& name);
// The same of a stepper.
std::string no_such_stepper(const std::string& name);
// Threads and contacts of a scene that was just built. False and why.
bool set_up(scenes::Scene& scene, const RunPlan& plan, std::string& problem);
// Prints the problem; the exit code of wrong usage.
int refuse(const std::string& problem);
// The same of a file that is no good; the exit code of a problem.
int complain(const std::string& path, const std::string& why);

}  // namespace epode::cli
