// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "joints/turn_count.h"

#include <gtest/gtest.h>

namespace epode::test {
namespace {

constexpr Real kClose = sizeof(Real) == 4 ? Real(1e-5) : Real(1e-12);

TEST(TurnCount, follows_the_last_angle)
{
    TurnCount turns;
    turns.take(Real(3.02));
    EXPECT_NEAR(turns.of(Real(3.18) - 2 * kPi, Real(-3.1), Real(3.1)), Real(3.18), kClose);
    turns.take(Real(12.5));
    EXPECT_NEAR(turns.of(Real(-0.2), 0, Real(18.85)), 4 * kPi - Real(0.2), kClose);
}

TEST(TurnCount, begins_at_the_nearer_stop)
{
    const TurnCount turns;
    EXPECT_NEAR(turns.of(Real(-1.6), Real(-0.1), Real(4.712)), 2 * kPi - Real(1.6), kClose);
    EXPECT_NEAR(turns.of(Real(-0.2), Real(-0.1), Real(4.712)), Real(-0.2), kClose);
    EXPECT_NEAR(turns.of(Real(2.5), -1, 1), Real(2.5), kClose);
    EXPECT_NEAR(turns.of(-3, 2, 3), 2 * kPi - 3, kClose);
    EXPECT_NEAR(turns.of(0, Real(3.5), Real(3.5)), 2 * kPi, kClose);
    EXPECT_NEAR(turns.of(2, -kInf, 1), 2, kClose);
}

// With stops more than a turn apart, an angle that is off by rounding is not a turn further.
TEST(TurnCount, begins_in_the_last_turn_of_a_wide_range)
{
    TurnCount turns;
    EXPECT_NEAR(turns.of(Real(-0.01), 0, Real(18.85)), Real(-0.01), kClose);
    EXPECT_NEAR(turns.of(-3, 0, Real(18.85)), 2 * kPi - 3, kClose);
    EXPECT_NEAR(turns.of(-3, Real(-6.28), Real(6.28)), -3, kClose);
    turns.last = Real(12.4);
    EXPECT_NEAR(turns.of(Real(0.5), 0, Real(18.85)), 4 * kPi + Real(0.5), kClose);
}

// Something has forced it by more than half a turn beyond a stop: it is behind the stops.
TEST(TurnCount, gives_up_half_a_turn_beyond)
{
    TurnCount turns;
    turns.take(Real(4.1));
    EXPECT_NEAR(turns.of(Real(4.14) - 2 * kPi, -1, 1), Real(4.14), kClose);
    EXPECT_NEAR(turns.of(Real(4.2) - 2 * kPi, -1, 1), Real(4.2) - 2 * kPi, kClose);
    turns.continuous = true;
    EXPECT_NEAR(turns.of(Real(4.2) - 2 * kPi, -1, 1), Real(4.2), kClose);
}

}  // namespace
}  // namespace epode::test
