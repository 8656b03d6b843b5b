// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How the points of one face share a load. Where more points touch than a load needs, the law of contact leaves open which of them carry
// it, and sweeps leave it at whatever came first, often nearly all on one point; a held body then turns about that point, which is a
// solution too. So sweeps begin with the last step's impulses drawn a little towards their mean: what the load fixes is found again, and
// what it leaves open becomes even within some ten steps.
#pragma once

#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

// Of the pair's forces, three a point, those along the normal, shared anew among the points that touch.
template <typename P>
EPODE_LANEWISE void share_load(const Work<P>& work, const P* forces, int points, const P& share, P* out)
{
    using T = typename P::Number;
    constexpr double kTouching = 1e-4;  // m
    P sum(0), count(0), touches[Work<P>::kMostPoints];
    for (int k = 0; k < points; ++k) {
        touches[k] = if_greater(P(T(kTouching)), work.gaps[k], P(1), P(0));
        sum = sum + touches[k] * forces[3 * k], count = count + touches[k];
    }
    const P mean = sum * inverse_or_zero(count);
    for (int k = 0; k < points; ++k) out[k] = forces[3 * k] + share * touches[k] * (mean - forces[3 * k]);
}

}  // namespace
}  // namespace epode::batch
