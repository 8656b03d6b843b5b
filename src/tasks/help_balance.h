// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Decides whether helper threads are worth waiting for. When another process takes a core, a helper on it
// loses the core in the middle of a piece of some microseconds, and the caller waits milliseconds until the
// scheduler returns it. Large steps still gain from helpers then, short ones lose. The caller therefore
// measures windows of time: if cores were lost in a window and more than half of it was spent waiting, the
// caller works alone for a while, and four times as long each time the next window shows the same. (Waiting
// alone proves nothing: the only large piece may be in the hands of a helper.)
//
// Time decides who does a piece, never its result: pieces have the same bits on any worker.
#pragma once

#include <atomic>

namespace epode {

class HelpBalance {
  public:
    // Nanoseconds of a monotonic clock.
    using Time = long long;
    static constexpr Time kWindow = 4'000'000, kMinRest = 64'000'000, kMaxRest = 1'024'000'000;

    // May be called while another thread calls note().
    bool worth(Time now) const { return now >= rest_until_.load(std::memory_order_relaxed); }

    // Records a job from `begin` to `end` in which the caller waited for `waited`; `lost` is how often
    // helpers have lost their cores so far.
    void note(Time begin, Time end, Time waited, unsigned lost)
    {
        worked_ += end - begin, waited_ += waited;
        if (worked_ < kWindow) return;
        if (waited_ > worked_ / 2 && lost != lost_before_) {
            rest_until_.store(end + rest_, std::memory_order_relaxed);
            rest_ = rest_ < kMaxRest / 4 ? 4 * rest_ : kMaxRest;
        } else {
            rest_ = kMinRest;
        }
        worked_ = waited_ = 0, lost_before_ = lost;
    }

  private:
    Time worked_ = 0, waited_ = 0;  // in this window
    unsigned lost_before_ = 0;
    Time rest_ = kMinRest;
    std::atomic<Time> rest_until_{0};
};

}  // namespace epode
