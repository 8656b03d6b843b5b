// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Spaces: rays against many boxes, and many boxes on the move, as bench/spaces asks for them.
#pragma once

#include <string>

namespace epode::bench {

struct SpaceOptions {
    std::string space = "hash";  // hash, quadtree, sap
    int boxes = 8'000;           // that rays are cast at, in a loose grid
    int rays = 2'000;
    int moving = 20'000;
    int steps = 20;
};

// Prints one line: rays a second by dSpaceCollide2 and dCollide, by dSpaceRayClosest and dSpaceRayBatch on
// one thread (0 where the library has none), hits and the sum of their distances by the first; then ms a step
// of moving all boxes and finding their pairs, and pairs in the last step. The answer is an exit status.
int bench_spaces(const SpaceOptions& options);

}  // namespace epode::bench
