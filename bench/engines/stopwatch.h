// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Time of this process's own work, all threads together, or of the wall. A shared machine takes the processor
// away for whole time slices, which the first does not see; with several threads only the second means speed.
#pragma once

#include <ctime>

namespace epode::bench {

class Stopwatch {
  public:
    explicit Stopwatch(bool wall) : clock_(wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID), last_(now()) {}

    // Milliseconds since the start or the last call.
    double lap()
    {
        const double before = last_;
        last_ = now();
        return last_ - before;
    }

  private:
    double now() const
    {
        timespec t{};
        clock_gettime(clock_, &t);
        return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
    }

    clockid_t clock_;
    double last_;
};

}  // namespace epode::bench
