// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All work is done in double, also in a single-precision build; every result is within 2 units of the last
// place.
//   sin, cos   x = k pi/2 + r, |r| <= pi/4, r kept as a sum high + low. For |k| < 2^20 by Cody-Waite
//              reduction with pi/2 in parts of 33 + 33 + 53 bits (the first two products are exact); up to
//              |x| = 1e15 with pi/2 in 53 + 53 + 53 bits and exact products. Beyond, one place of x is a good
//              part of a turn: the remainder modulo 2 pi in double stands for the phase. Then the Taylor
//              series to r^17 and r^16: remainder below 1e-17 on the interval; the low part enters to first
//              order.
//   atan       t = min/max of the arguments; atan(t) = atan(c) + atan((t - c)/(1 + t c)) with c the nearest
//              multiple of 1/8, but 0 below 3/32, where the difference would cancel; then the series to u^17
//              on |u| < 3/32: remainder below 1e-20. The multiples of pi/2 and atan(c) are sums of two
//              doubles.
// Cody & Waite, "Software Manual for the Elementary Functions", 1980; exact products after Dekker, Numer.
// Math. 18 (1971). Minimax coefficients would save a few multiplications; the series can be checked by eye.
#include "math/trig.h"

#include <cmath>

namespace epode {
namespace {

constexpr double kPiDouble = 3.14159265358979323846;

struct Sum {
    double high, low;
};

// a + b and a b without error.
Sum two_sum(double a, double b)
{
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}

Sum two_product(double a, double b)
{
    constexpr double kSplit = 134217729;  // 2^27 + 1
    const double ca = kSplit * a, cb = kSplit * b;
    const double ah = ca - (ca - a), bh = cb - (cb - b), al = a - ah, bl = b - bh, p = a * b;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

// x - k pi/2
Sum reduce_small(double x, double k)
{
    constexpr double kPart1 = 1.57079632673412561417e+00;  // first 33 bits of pi/2
    constexpr double kPart2 = 6.07710050630396597660e-11;  // next 33 bits
    constexpr double kPart3 = 2.02226624879595063154e-21;  // the rest
    const Sum r = two_sum(x - k * kPart1, -(k * kPart2));
    const Sum s = two_sum(r.high, -(k * kPart3));
    return {s.high, s.low + r.low};
}

Sum reduce_large(double x, double k)
{
    constexpr double kPart1 = 1.5707963267948966;
    constexpr double kPart2 = 6.123233995736766e-17;
    constexpr double kPart3 = -1.4973849048591698e-33;
    const Sum p1 = two_product(k, kPart1), p2 = two_product(k, kPart2);
    const Sum a = two_sum(x, -p1.high), b = two_sum(a.high, -p1.low), c = two_sum(b.high, -p2.high);
    const Sum d = two_sum(c.high, a.low + b.low + c.low - p2.low - k * kPart3);
    return d;
}

double sin_series(Sum r)
{
    const double x = r.high, s = x * x;
    double p = 1.0 / 355687428096000.0;
    p = p * s - 1.0 / 1307674368000.0;
    p = p * s + 1.0 / 6227020800.0;
    p = p * s - 1.0 / 39916800.0;
    p = p * s + 1.0 / 362880.0;
    p = p * s - 1.0 / 5040.0;
    p = p * s + 1.0 / 120.0;
    p = p * s - 1.0 / 6.0;
    return x + (x * (s * p) + r.low * (1 - 0.5 * s));
}

double cos_series(Sum r)
{
    const double x = r.high, s = x * x;
    double p = 1.0 / 20922789888000.0;
    p = p * s - 1.0 / 87178291200.0;
    p = p * s + 1.0 / 479001600.0;
    p = p * s - 1.0 / 3628800.0;
    p = p * s + 1.0 / 40320.0;
    p = p * s - 1.0 / 720.0;
    p = p * s + 1.0 / 24.0;
    const double half = 0.5 * s, head = 1 - half;
    return head + (((1 - head) - half) + (s * (s * p) - x * r.low));
}

// sin(x + quarter pi/2)
double sin_shifted(double x, int quarter)
{
    if (!(std::fabs(x) <= 1e15)) x = std::fmod(x, 2 * kPiDouble);  // NaN for NaN and infinity
    if (std::isnan(x)) return x;
    const double k = std::floor(x * (2 / kPiDouble) + 0.5);
    const Sum r = std::fabs(k) < 1048576 ? reduce_small(x, k) : reduce_large(x, k);
    const int quadrant = int((static_cast<long long>(k) + quarter) & 3);
    const double value = (quadrant & 1) ? cos_series(r) : sin_series(r);
    return (quadrant & 2) ? -value : value;
}

// atan(i/8), i = 0..8.
constexpr Sum kAtanEighths[9] = {
    {0.0, 0.0},
    {0.12435499454676144, -3.1253241424539383e-18},
    {0.24497866312686414, 1.0698755618734451e-17},
    {0.35877067027057225, -2.4623815582638635e-17},
    {0.4636476090008061, 2.2698777452961687e-17},
    {0.5585993153435624, -5.4556305485916264e-18},
    {0.6435011087932844, 1.5834785051444286e-17},
    {0.7188299996216245, -2.1478388444456983e-17},
    {0.7853981633974483, 3.061616997868383e-17},
};
constexpr Sum kHalfPi = {1.5707963267948966, 6.123233995736766e-17};

double atan2_double(double y, double x)
{
    const double ax = std::fabs(x), ay = std::fabs(y);
    if (ax == 0 && ay == 0) return 0;
    const bool steep = ay > ax;
    double t = steep ? ax / ay : ay / ax;
    if (ax == ay) t = 1;  // also for two infinities
    if (std::isnan(t)) return t;
    const int i = t < 0.09375 ? 0 : int(8 * t + 0.5);
    const double c = i / 8.0, u = (t - c) / (1 + t * c), s = u * u;
    double p = 1.0 / 17.0;
    for (int n = 15; n >= 3; n -= 2) p = 1.0 / n - s * p;
    const double rest = (u - u * (s * p)) + kAtanEighths[i].low;
    // The angle is n pi/2 plus or minus what t stands for.
    const int n = steep ? 1 : x < 0 ? 2 : 0;
    const double sign = steep != (x < 0) ? -1 : 1;
    const Sum head = two_sum(n * kHalfPi.high, sign * kAtanEighths[i].high);
    const double angle = head.high + (head.low + (n * kHalfPi.low + sign * rest));
    return y < 0 ? -angle : angle;
}

}  // namespace

Real sin(Real x) { return Real(sin_shifted(double(x), 0)); }
Real cos(Real x) { return Real(sin_shifted(double(x), 1)); }
Real atan2(Real y, Real x) { return Real(atan2_double(double(y), double(x))); }

Real acos(Real x)
{
    const double c = x > 1 ? 1.0 : x < -1 ? -1.0 : double(x);
    // sqrt(1 - c^2), corrected by what the product and the root have rounded away.
    const Sum square = two_product(1 - c, 1 + c);
    double s = std::sqrt(square.high);
    if (s > 0) {
        const Sum back = two_product(s, s);
        s += ((square.high - back.high) - back.low + square.low) / (2 * s);
    }
    return Real(atan2_double(s, c));
}

Real sinc(Real x)
{
    // Below 1e-4 the first two terms are exact to rounding.
    if (std::fabs(x) < Real(1e-4)) return 1 - x * x / 6;
    return sin(x) / x;
}

}  // namespace epode
