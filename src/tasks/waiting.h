// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A thread that waits for the others to finish: it spins first, because they mostly need microseconds, and
// then yields, because one may have lost its core. The time that it waits beyond its spins is counted.
#pragma once

#include <time.h>

#include "base/threads/spin.h"

namespace epode {

inline long long nanoseconds_now()
{
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1'000'000'000LL + t.tv_nsec;
}

extern constinit thread_local long long t_waited;  // nanoseconds, ever

class Waiting {
  public:
    Waiting() = default;
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting() { end(); }

    void once()
    {
        constexpr int kShortWait = 2000;  // tens of microseconds
        if (spins_ < kShortWait) {
            ++spins_;
            spin_once();
            return;
        }
        if (!counted_) begin_ = nanoseconds_now(), counted_ = true;
        yield_core();
    }

    // The wait is over; the next one begins with spins again.
    void end()
    {
        if (counted_) t_waited += nanoseconds_now() - begin_;
        spins_ = 0, counted_ = false;
    }

  private:
    int spins_ = 0;
    bool counted_ = false;
    long long begin_ = 0;
};

}  // namespace epode
