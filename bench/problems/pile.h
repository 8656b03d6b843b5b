// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Loose piles of boxes as files: bodies with pose and velocity, and their contacts. A file and not a
// simulation at each start, because the libraries would pour two different piles.
#pragma once

#include "bench/problems/problem.h"

namespace epode::bench {

// False, with a message, when there is no such file or it is damaged.
bool load_pile(Problem& problem, int count);

// Drops `count` boxes at random into a square pit of side `side` m with the library at hand and prints the
// file of the first moment at which they have at least `rows` rows. 0 fine, 1 it never came to that.
int print_pile(int count, double side, int rows, std::uint32_t seed);

}  // namespace epode::bench
