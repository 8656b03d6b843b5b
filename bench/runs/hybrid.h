// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hybrid steps compared with substeps in the same worlds, which the game preset has set up: mean, median, 99th
// percentile and worst step.
#pragma once

namespace epode::bench {

struct HybridOptions {
    int steps = 300;
    bool large = false;  // 10,000 pieces of debris, too
};

int bench_hybrid(const HybridOptions& options);

}  // namespace epode::bench
