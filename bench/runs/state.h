// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What it costs to keep the state of a world and to give it back, and to read and set bodies as arrays.
#pragma once

namespace epode::bench {

struct StateOptions {
    int boxes = 1000;     // in a pile
    int steps = 300;      // before the first is timed
    int rounds = 50;      // that are timed; the median counts
    bool sleeps = false;  // boxes may fall asleep
};

int bench_state(const StateOptions& options);

}  // namespace epode::bench
