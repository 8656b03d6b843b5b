// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Times the exact stepper on islands of 12 to 300 rows, where a dense method is at home and a cleverer one
// must show that it costs nothing.
#pragma once

namespace epode::bench {

struct SizesOptions {
    int steps = 60;
    int repeat = 3;
    bool json = false;
};

int bench_exact_sizes(const SizesOptions& options);

}  // namespace epode::bench
