// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot's file in a world of the robot preset, its actuators under random controls that are held for five steps: time and quality of its
// steps. bench/loaded_robots.py does it in turns with MuJoCo.
#pragma once

#include <string>

namespace epode::bench {

struct LoadedRobotOptions {
    std::string file;
    int steps = 1000;
    double h = 0.002;  // s
    bool no_quality = false;
};

int bench_loaded_robot(const LoadedRobotOptions& options);

}  // namespace epode::bench
