// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Time owed is kept from call to call, so that steps longer than a frame come at their right times.
#include "view/session/session.h"

#include <chrono>

namespace epode::view {

void Session::pass(double seconds, double max_seconds)
{
    if (paused) {
        owed_ = 0;
        return;
    }
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    owed_ += seconds * speed;
    for (double dt = next_dt(); dt > 0 && owed_ >= dt; dt = next_dt()) {
        if (!step()) break;
        owed_ -= dt;
        if (std::chrono::duration<double>(Clock::now() - start).count() > max_seconds) {
            owed_ = 0;
            return;
        }
    }
    if (next_dt() <= 0) owed_ = 0;
}

std::vector<record::Limit> Session::limits(std::uint32_t joint) const
{
    std::vector<record::Limit> found;
    for (const record::Limit& limit : state().step.limits) {
        if (limit.stop.joint == joint) found.push_back(limit);
    }
    return found;
}

}  // namespace epode::view
