// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What stands between controls and forces: act' = u (integrator), (u - act) / T (filters). A filter's step is h / T of the way, at most
// all of it; the exact one's 1 - exp(-h / T).
#pragma once

#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

// 1 - exp(-x), of x doubled from where the series is short: 1 - (1 - u)^2 = u (2 - u).
template <typename P>
EPODE_LANEWISE P approached(const P& x)
{
    using T = typename P::Number;
    const P one(1), y = at_most(x, P(T(40))) * P(T(1.0 / 4096)), half(T(0.5)), third(T(1.0 / 3)),
                    quarter(T(0.25)), fifth(T(0.2));
    P u = y * (one - half * y * (one - third * y * (one - quarter * y * (one - fifth * y))));
    for (int i = 0; i < 12; ++i) u = u * (P(2) - u);
    return u;
}

// Moves the activation on by a step, and returns what acts through it.
template <typename P, bool own>
P filtered(const BatchActuator& a, const Numbers<P, own>& numbers, const P& now, const P& control, const P& h,
           P& next)
{
    using T = typename P::Number;
    using Kind = robots::Activation::Kind;
    const auto number = [&](int which) { return numbers[a.filter_first + which]; };
    const P steps = h / at_least(number(filter_number::kTime), P(T(sizeof(T) == 4 ? 1e-15f : 1e-15)));
    const P share = a.kind == Kind::kFilter ? at_most(steps, P(1)) : approached(steps);
    const P moved = a.kind == Kind::kIntegrator ? now + h * control : now + share * (control - now);
    next = clip(moved, number(filter_number::kLow), number(filter_number::kHigh));
    return a.is_early ? next : now;
}

}  // namespace
}  // namespace epode::batch
