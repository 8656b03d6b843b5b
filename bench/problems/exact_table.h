// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Times dWorldStep on the problems of problem_list.h; bench/exact runs it on two libraries in turn and makes
// the table of both.
#pragma once

#include <string>

namespace epode::bench {

struct TableOptions {
    std::string problem;     // empty: all
    std::string velocities;  // a file to write every body's velocity after the first step to; empty: none
    double seconds = 0.3;    // stop timing a problem after that, but not before three steps
    int steps = 2000;        // or after as many steps
    std::string untimed;     // warm or cold: only take the steps, for a tool that counts what they do
};

// 0 fine, 1 a problem that cannot be made or a state that is not finite, 2 wrong usage.
int bench_exact_table(const TableOptions& options);

}  // namespace epode::bench
