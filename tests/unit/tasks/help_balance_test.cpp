// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// When the caller of a job goes without helpers: only if cores were lost, only if that cost more than half of
// the time, for longer and longer, and never for longer than the limit.
#include "tasks/help_balance.h"

#include <gtest/gtest.h>

namespace epode {
namespace {

using Time = HelpBalance::Time;
constexpr Time kJob = 100'000;

struct Caller {
    HelpBalance balance;
    Time now = 1'000'000'000;
    unsigned lost = 0;

    // Jobs for one window.
    void work(double waited_part, bool loses)
    {
        if (loses) ++lost;
        for (Time t = 0; t < HelpBalance::kWindow; t += kJob) {
            balance.note(now, now + kJob, Time(waited_part * kJob), lost);
            now += kJob;
        }
    }

    // How long it goes alone from now on.
    Time rest()
    {
        const Time begin = now;
        while (!balance.worth(now)) now += kJob;
        return now - begin;
    }
};

TEST(HelpBalance, waits_for_helpers_that_work_are_no_reason)
{
    Caller caller;
    for (int window = 0; window < 100; ++window) {
        caller.work(0.95, false);
        ASSERT_EQ(caller.rest(), 0) << window;
    }
}

TEST(HelpBalance, lost_cores_that_cost_less_than_help_is_worth_are_no_reason)
{
    Caller caller;
    for (int window = 0; window < 100; ++window) {
        caller.work(0.45, true);
        ASSERT_EQ(caller.rest(), 0) << window;
    }
}

TEST(HelpBalance, rests_grow_to_a_limit_and_shrink_when_the_core_is_back)
{
    Caller caller;
    Time before = 0;
    for (int window = 0; window < 6; ++window) {
        caller.work(0.8, true);
        const Time rest = caller.rest();
        ASSERT_GE(rest, before);
        ASSERT_LE(rest, HelpBalance::kMaxRest + kJob);
        before = rest;
    }
    EXPECT_GE(before, HelpBalance::kMaxRest);
    caller.work(0.1, false);
    EXPECT_EQ(caller.rest(), 0);
    caller.work(0.8, true);
    EXPECT_LE(caller.rest(), HelpBalance::kMinRest + kJob);
}

// A core that another process holds for good: what helpers cost is a few hundredths of the time.
TEST(HelpBalance, a_core_that_stays_lost_costs_little)
{
    Caller caller;
    const Time begin = caller.now;
    Time waited = 0;
    while (caller.now - begin < 10'000'000'000) {
        caller.work(0.8, true);
        waited += Time(0.8 * HelpBalance::kWindow);
        caller.rest();
    }
    EXPECT_LT(double(waited), 0.03 * double(caller.now - begin));
}

}  // namespace
}  // namespace epode
