// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All work is done in double, also in a single-precision build.
//   sin, cos   x = k pi/2 + r, |r| <= pi/4, by Cody-Waite reduction with pi/2 in three parts (33 + 33 + 53
//              bits, exact products for |k| < 2^20; beyond that the accuracy falls off, never the result's
//              range), then the Taylor series to r^17 and r^16: remainder below 1e-17 on the interval.
//   atan       argument halved twice by atan(t) = 2 atan(t / (1 + sqrt(1 + t^2))), then the series to t^21
//              on |t| <= tan(pi/16): remainder below 1e-17.
// Cody & Waite, "Software Manual for the Elementary Functions", 1980. Minimax coefficients would save a few
// multiplications; the series can be checked by eye.
#include "math/trig.h"

#include <cmath>

namespace epode {
namespace {

constexpr double kHalfPi1 = 1.57079632673412561417e+00;  // first 33 bits of pi/2
constexpr double kHalfPi2 = 6.07710050630396597660e-11;  // next 33 bits
constexpr double kHalfPi3 = 2.02226624879595063154e-21;  // the rest
constexpr double kPiDouble = 3.14159265358979323846;

double sin_series(double r)
{
    const double s = r * r;
    double p = 1.0 / 355687428096000.0;
    p = p * s - 1.0 / 1307674368000.0;
    p = p * s + 1.0 / 6227020800.0;
    p = p * s - 1.0 / 39916800.0;
    p = p * s + 1.0 / 362880.0;
    p = p * s - 1.0 / 5040.0;
    p = p * s + 1.0 / 120.0;
    p = p * s - 1.0 / 6.0;
    return r + r * (s * p);
}

double cos_series(double r)
{
    const double s = r * r;
    double p = 1.0 / 20922789888000.0;
    p = p * s - 1.0 / 87178291200.0;
    p = p * s + 1.0 / 479001600.0;
    p = p * s - 1.0 / 3628800.0;
    p = p * s + 1.0 / 40320.0;
    p = p * s - 1.0 / 720.0;
    p = p * s + 1.0 / 24.0;
    return 1.0 + (s * (s * p) - 0.5 * s);
}

// sin(x + quarter pi/2)
double sin_shifted(double x, int quarter)
{
    if (!(std::fabs(x) <= 1e15)) return x - x;  // NaN for NaN and infinity, 0 where x has no phase left
    const double k = std::floor(x * (2 / kPiDouble) + 0.5);
    const double r = ((x - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
    const int quadrant = int((static_cast<long long>(k) + quarter) & 3);
    const double value = (quadrant & 1) ? cos_series(r) : sin_series(r);
    return (quadrant & 2) ? -value : value;
}

// atan(t) for 0 <= t <= 1
double atan_unit(double t)
{
    t = t / (1 + std::sqrt(1 + t * t));
    t = t / (1 + std::sqrt(1 + t * t));
    const double s = t * t;
    double p = 1.0 / 21.0;
    for (int n = 19; n >= 3; n -= 2) p = 1.0 / n - s * p;
    return 4 * (t - t * (s * p));
}

double atan2_double(double y, double x)
{
    const double ax = std::fabs(x), ay = std::fabs(y);
    if (ax == 0 && ay == 0) return 0;
    double angle = ay <= ax ? atan_unit(ay / ax) : kPiDouble / 2 - atan_unit(ax / ay);
    if (x < 0) angle = kPiDouble - angle;
    return y < 0 ? -angle : angle;
}

}  // namespace

Real sin(Real x) { return Real(sin_shifted(double(x), 0)); }
Real cos(Real x) { return Real(sin_shifted(double(x), 1)); }
Real atan2(Real y, Real x) { return Real(atan2_double(double(y), double(x))); }

Real acos(Real x)
{
    const double c = x > 1 ? 1.0 : x < -1 ? -1.0 : double(x);
    return Real(atan2_double(std::sqrt((1 - c) * (1 + c)), c));
}

Real sinc(Real x)
{
    // Below 1e-4 the first two terms are exact to rounding.
    if (std::fabs(x) < Real(1e-4)) return 1 - x * x / 6;
    return sin(x) / x;
}

}  // namespace epode
