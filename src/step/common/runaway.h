// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies whose motion means nothing any more: an unstable controller multiplies a speed in each step, and numbers stay finite
// up to 1e100. The limit is 1e10 m/s or rad/s. Light makes 3e8 m/s; nothing larger than the nanoparticles that lasers spin turns
// as fast; and in steps of 1 ms a body flies 1e7 m, of which doubles know 1e-9. The program learns of the first such step of
// a world, and of the first in which an island was contained, in one message; steps go on.
#pragma once

#include <atomic>

#include "base/check.h"
#include "dynamics/body.h"

namespace epode {

inline constexpr Real kRunawaySpeed = Real(1e10);

inline bool runs_away(const Body& body)
{
    bool fast = false;
    for (int i = 0; i < 3; ++i)
        fast |= int{!within(body.lvel[i], kRunawaySpeed)} | int{!within(body.avel[i], kRunawaySpeed)};
    return fast;
}

class Runaways {
  public:
    // During a step, on any thread; of all bodies the oldest one is named.
    void check(const Body& body)
    {
        if (runs_away(body)) [[unlikely]]
            add(body);
    }
    [[gnu::cold]] void add(const Body& body);
    // The step has been undone.
    void take_back() { oldest_.store(kNobody, std::memory_order_relaxed); }
    // Between steps, on the thread that has asked for them, when nothing of them is left on the stack: sends the message, whose
    // handler may leave by an exception.
    void report(const World& world)
    {
        if (oldest_.load(std::memory_order_relaxed) != kNobody && !reported_) [[unlikely]]
            send(world);
    }

  private:
    static constexpr std::uint64_t kNobody = ~0ull;

    [[gnu::cold]] void send(const World& world);

    std::atomic<std::uint64_t> oldest_{kNobody};  // serial
    bool reported_ = false;
};

}  // namespace epode
