// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps compared with substeps in the same worlds, which the game preset has set up: mean, median, 99th
// percentile and worst step.
#pragma once

#include <string>

namespace epode::bench {

struct HybridOptions {
    int steps = 300;
    bool large = false;  // 10,000 pieces of debris, too
    std::string only;    // hybrid steps of this world alone
    int size = 0;        // of it; 0: its own
};

int bench_hybrid(const HybridOptions& options);

}  // namespace epode::bench
