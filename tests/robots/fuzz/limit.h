// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a reader may take of the processor, whatever else the machine does: 2 s, SDF 20, most of them libsdformat's. What takes longer
// aborts, which libFuzzer reports as a crash.
#pragma once

#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace epode::fuzz {

class TimeLimit {
  public:
    ~TimeLimit()
    {
        if (seconds() - began_ < kMaxSeconds) return;
        std::fprintf(stderr, "took more than %g s of the processor\n", kMaxSeconds);
        std::abort();
    }

  private:
    static double seconds()
    {
        timespec now;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }

    static constexpr double kMaxSeconds = std::string_view(EPODE_ENDING) == "sdf" ? 20 : 2;
    const double began_ = seconds();
};

}  // namespace epode::fuzz
