// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The root of a rising function between two ends of opposite sign: false position in the Illinois form
// (Dowell and Jarratt 1971), with a bisection whenever a step has not halved the bracket. Slopes here have
// kinks, near which plain false position creeps. At most about two evaluations per bit; near a smooth root
// six to ten in all.
#pragma once

#include "base/config.h"

namespace epode {

template <class Function>
Real rising_root(const Function& f, Real lo, Real at_lo, Real hi, Real at_hi)
{
    constexpr int kSteps = 120;
    int side = 0;
    bool bisect = false;
    Real t = lo, last = kInf;  // `last`: the interpolated point before
    for (int i = 0; i < kSteps && hi - lo > 2 * kEpsilon; ++i) {
        const Real width = hi - lo;
        t = lo + width * (bisect ? Real(0.5) : at_lo / (at_lo - at_hi));
        if (!(t > lo && t < hi)) t = Real(0.5) * (lo + hi);
        if (!bisect) {
            if (t - last <= 32 * kEpsilon && last - t <= 32 * kEpsilon) return t;
            last = t;
        }
        const Real s = f(t);
        if (s == 0) return t;
        if (s < 0) {
            lo = t, at_lo = s;
            if (side < 0) at_hi *= Real(0.5);
            side = -1;
        } else {
            hi = t, at_hi = s;
            if (side > 0) at_lo *= Real(0.5);
            side = 1;
        }
        bisect = !bisect && hi - lo > Real(0.5) * width;
    }
    return t;
}

}  // namespace epode
