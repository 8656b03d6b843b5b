// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Half-turns in lanes: sine and cosine of half an angle, up to a common sign, which a quaternion does not feel. The half-angle is
// reduced by multiples of pi to -pi/2 ... pi/2 (Cody and Waite: pi in three parts, so that the products are exact for 2^20 turns) and
// put into the Taylor series, to the term below half a unit in the last place.
#pragma once

#include "simd/pack.h"
#include "simd/pack_algebra.h"

namespace epode::batch {
namespace {

template <typename P>
struct SineCosine {
    P sine, cosine;
};

// To the nearest whole number, ties to even, below 2^22 (2^51).
template <typename P>
EPODE_LANEWISE P rounded(const P& x)
{
    const P magic(sizeof(typename P::Number) == 4 ? typename P::Number(12582912.0)
                                                  : typename P::Number(6755399441055744.0));
    return (x + magic) - magic;
}

template <typename P>
EPODE_LANEWISE SineCosine<P> half_turn(const P& angle)
{
    using T = typename P::Number;
    constexpr bool kFloat = sizeof(T) == 4;
    const P half = P(T(0.5)) * angle, n = rounded(half * P(T(0.31830988618379067154)));
    const P part1(kFloat ? T(3.140625) : T(3.141592651605606079101563)),
        part2(kFloat ? T(0.000967502593994140625) : T(1.984187158327044286920682e-9)),
        part3(kFloat ? T(1.509957883192319270670e-7) : T(1.034036596358821027054e-18));
    const P r = ((half - n * part1) - n * part2) - n * part3, x = r * r;
    constexpr int kTerms = kFloat ? 6 : 11;
    P s(T(1)), c(T(1));
    for (int k = kTerms; k >= 1; --k) {
        s = P(T(1)) - s * (x * P(T(1.0 / (2 * k * (2 * k + 1)))));
        c = P(T(1)) - c * (x * P(T(1.0 / (2 * k * (2 * k - 1)))));
    }
    return {r * s, c};
}

}  // namespace
}  // namespace epode::batch
