// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "joints/turn_count.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

// How far outside of a range of about a turn or more an angle begins at most, rad.
constexpr Real kSlack = Real(0.1);

bool within_half_turn(Real lo, Real hi) { return (lo >= -kPi || lo == -kInf) && (hi <= kPi || hi == kInf); }

Real begin(Real angle, Real last, Real lo, Real hi)
{
    const bool two_sided = lo > -kInf && hi < kInf;
    const Real inset = two_sided ? std::min((hi - lo) / 2, kPi - kSlack) : 0;
    const Real hint = within_half_turn(lo, hi) ? 0 : last;
    return nearest_turn(angle, std::min(std::max(hint, lo + inset), hi - inset));
}

}  // namespace

Real nearest_turn(Real angle, Real to)
{
    constexpr Real kTurn = 2 * kPi;
    return angle + kTurn * std::round((to - angle) / kTurn);
}

Real TurnCount::of(Real angle, Real lo, Real hi) const
{
    const Real next = nearest_turn(angle, last);
    if (continuous) return next;
    if (!follows) return begin(angle, last, lo, hi);
    // What has been forced by half a turn beyond stops within one turn is behind them.
    const bool behind = next < lo - kPi || next > hi + kPi;
    return behind && within_half_turn(lo, hi) ? begin(angle, last, lo, hi) : next;
}

}  // namespace epode
