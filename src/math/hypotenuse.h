// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// sqrt(x^2 + y^2) with the same bits on every machine: hypot() of C libraries differs in the last place. The
// root h of the rounded sum is wrong by up to an ulp; one Newton step removes nearly all of it, with the
// residual h^2 - x^2 - y^2 written as products of small differences (C. F. Borges, An improved algorithm for
// hypot(a, b), arXiv 1904.09481, the form without fused operations). glibc 2.36 returns the same, but for
// subnormal numbers.
#pragma once

#include <cmath>

#include "base/config.h"

namespace epode {

inline double corrected_hypotenuse(double a, double b)  // a >= b >= 0
{
    const double h = std::sqrt(a * a + b * b);
    if (h <= 2 * b) {
        const double d = h - b;
        return h - (a * (2 * d - a) + (d - 2 * (a - b)) * d) / (2 * h);
    }
    const double d = h - a;
    return h - (2 * d * (a - 2 * b) + ((4 * d - b) * b + d * d)) / (2 * h);
}

inline double hypotenuse(double x, double y)
{
    const double u = std::fabs(x), v = std::fabs(y), a = u > v ? u : v, b = u > v ? v : u;
    constexpr double kTiny = 0x1p-400, kHuge = 0x1p500, kScale = 0x1p600;
    if (b <= a * 0x1p-54) return a + b;
    if (a > kHuge) return kScale * corrected_hypotenuse(a / kScale, b / kScale);
    if (a < kTiny) return corrected_hypotenuse(a * kScale, b * kScale) / kScale;
    return corrected_hypotenuse(a, b);
}

// Squares of floats are exact in double.
inline float hypotenuse(float x, float y) { return float(std::sqrt(double(x) * x + double(y) * y)); }

}  // namespace epode
