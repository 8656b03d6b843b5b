// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dCollide pair by pair: nanoseconds, how many of the poses touch, and how many contacts they have.
#pragma once

#include <string>

namespace epode::bench {

struct PairOptions {
    std::string first, second;  // members; empty: all
    std::string set;            // resting, tumbled or apart; empty: all
    int poses = 500;
    int rounds = 5;  // the quickest counts
};

int bench_pairs(const PairOptions& options);

}  // namespace epode::bench
