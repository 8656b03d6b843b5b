// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step costs where most of the world sleeps.
#pragma once

namespace epode::bench {

struct AsleepOptions {
    int boxes = 20'000;  // in columns of four
    int awake = 100;     // balls that roll next to them
    int steps = 100;     // that are timed
    bool no_space = false;
};

int bench_asleep(const AsleepOptions& options);

}  // namespace epode::bench
