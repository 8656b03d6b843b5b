// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Many small worlds, each with one and the same scene: steps of a world per second, in a loop of single steps
// and in one call for all.
#pragma once

#include <string>

namespace epode::bench {

struct WorldsOptions {
    std::string scene = "S4";  // of the benchmark scenes; its contacts are the worlds' own business
    int size = 1;              // of the scene
    int worlds = 64;
    int steps = 20;  // of each world in a round
    int rounds = 15;
    std::string stepper = "fast";
};

int bench_worlds(const WorldsOptions& options);

}  // namespace epode::bench
