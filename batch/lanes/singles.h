// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of one direction each: limits, dry friction, servos, sums of coordinates. What they have in common: the law of a gap or an error,
// and where sweeps begin.
//   gap g > 0   may close within the step, not more: J v >= -g / h
//   overlap     a share of it is taken back: J v >= min(erp (-g) / h, most)
//   spring k, d force -k (g + h J v) - d J v: J v + impulse / (h (h k + d)) >= -g k / (h k + d)
#pragma once

#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

template <typename P>
struct Law {
    P bias, soft;
    P gap{}, slope{};  // where the bias is one of a gap: d bias / d gap on this side of its corners
    bool has_gap = false;
};

template <typename P>
EPODE_LANEWISE Law<P> law_of(const P& gap, const P& stiffness, const P& damping, const StepOptions& options)
{
    using T = typename P::Number;
    const P h(T(options.h)), rate(T(1 / options.h)), implicit = h * stiffness + damping;
    const P soft = if_positive(stiffness, P(1) / (h * implicit), P(0));
    const P share = if_positive(stiffness, stiffness / implicit, P(T(options.erp / options.h)));
    const P back = at_most(P(T(options.most_correction)), share * -gap);
    const P slope = if_greater(P(T(options.most_correction)), share * -gap, -share, P(0));
    return {if_positive(gap, -gap * rate, back), soft, gap, if_positive(gap, -rate, slope), true};
}

// Where the row's y is, and z of the dofs that it moves.
template <typename P>
struct Direction {
    const P* y;
    P* const* z;
    int width;
    const P* shares = nullptr;  // what loops have taken of it
};

template <typename P>
struct Singles {
    using T = typename P::Number;
    const StepOptions& options;
    const P* forces;  // of the last step, of all constraints
    Work<P>& work;

    // at: among all impulses.
    SingleRow<P>& add(const Direction<P>& along, int at, const P& sign, const P& wanted,
                      const Law<P>& law) const
    {
        SingleRow<P>& row = work.singles[work.single_count++];
        row.y = along.y, row.z = along.z, row.width = along.width, row.shares = along.shares,
        row.impulse = work.impulses + at;
        P square(0);
        for (int k = 0; k < row.width; ++k) square = square + row.y[k] * row.y[k];
        row.sign = sign, row.bias = law.bias, row.soft = law.soft;
        row.d = if_positive(wanted, square + law.soft, P(0)), row.mass = inverse_or_zero(row.d);
        row.gap = law.gap, row.slope = law.slope, row.has_gap = law.has_gap;
        return row;
    }

    // Once its bounds are known.
    void begin(const SingleRow<P>& row, int at) const
    {
        *row.impulse = clip(if_positive(row.d, P(T(options.h)) * forces[at], P(0)), row.low, row.high);
        for (int k = 0; k < row.width; ++k) *row.z[k] = *row.z[k] + row.sign * (row.y[k] * *row.impulse);
    }
};

}  // namespace
}  // namespace epode::batch
