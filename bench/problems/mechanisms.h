// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step of a robot's world costs in dWorldsStep: worlds of one mechanism, each with its own random
// torques.
#pragma once

#include <string>

namespace epode::bench {

struct MechanismOptions {
    std::string model = "ant";
    std::string stepper = "exact";
    int worlds = 64;
    int threads = 1;
    int projection = 0;  // Newton steps on positions after a step
    int settle = 50;     // steps before the first that is timed
    int steps = 500;     // of each world, that are timed
    int rounds = 3;      // they are timed in; the quickest counts
};

int bench_mechanisms(const MechanismOptions& options);

}  // namespace epode::bench
