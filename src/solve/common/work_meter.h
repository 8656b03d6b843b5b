// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Counts the work of a solution as it is done, so that one that takes more than it may can be given up: the
// same on every machine and any number of threads, where a clock would not be. Times are those of the loops
// on one core of an AMD EPYC (Zen 5, 28 November 2026), to about a third.
#pragma once

namespace epode {

struct WorkMeter {
    double limit;      // microseconds
    double spent = 0;  // likewise

    bool exhausted() const { return spent > limit; }
};

}  // namespace epode
