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
    bool listed = false;
};

int bench_pairs(const PairOptions& options);

// Reads lines `FIRST SECOND [SELECTED]` from standard input, in any order of the two. For each prints
// `FIRST SECOND COUNTS`, a digit with the number of contacts per pose, all sets after each other; or, for
// those poses that SELECTED has a 1 for, `FIRST SECOND NS` a call.
int bench_listed_pairs(int poses);

}  // namespace epode::bench
