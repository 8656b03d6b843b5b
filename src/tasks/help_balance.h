// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Whether other threads help more than they are waited for. When another process holds a core, a helper that
// was on it loses it in the middle of a piece of some microseconds, and the caller waits milliseconds for the
// scheduler to give it back. Large steps still win by helpers then, short ones lose. So the caller counts:
// when of a window of time in which cores were lost more than half was waited, the caller works alone for a
// while, and for four times as long each time that the next window says the same. (Waits alone say nothing:
// one may wait for a helper that has the only large piece.)
//
// Time decides who does a piece, never what comes out: pieces have the same bits on any worker.
#pragma once

#include <atomic>

namespace epode {

class HelpBalance {
  public:
    // Nanoseconds of one clock that never goes back.
    using Time = long long;
    static constexpr Time kWindow = 4'000'000, kMinRest = 64'000'000, kMaxRest = 1'024'000'000;

    // May be asked while another thread notes.
    bool worth(Time now) const { return now >= rest_until_.load(std::memory_order_relaxed); }

    // A job from `begin` to `end`, in which its caller waited so long; helpers lost their cores so often,
    // ever.
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
