// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Linked into OMPL's demo, which draws a new seed at each start: the same plan each time, so that two
// libraries can be compared.
#include <ompl/util/RandomNumbers.h>

namespace {

struct Seed {
    Seed() { ompl::RNG::setSeed(1); }
} seed;

}  // namespace
