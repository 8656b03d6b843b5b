// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2: 106 bits. Sums by Knuth's two-sum, products
// by Dekker's splitting (Numer. Math. 18, 1971), which needs no fused multiply-add and so gives the same bits
// everywhere. For the few places where large numbers must cancel to something small; long double has too few
// bits more and differs between machines.
#pragma once

namespace epode {

struct DoubleDouble {
    double hi = 0, lo = 0;
};

// a + b exactly.
inline DoubleDouble two_sum(double a, double b)
{
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}

// The same for |a| >= |b|.
inline DoubleDouble quick_two_sum(double a, double b)
{
    const double s = a + b;
    return {s, b - (s - a)};
}

// a b exactly, below 1e292.
inline DoubleDouble two_product(double a, double b)
{
    constexpr double kSplit = 134217729;  // 2^27 + 1
    const double p = a * b, ta = kSplit * a, tb = kSplit * b;
    const double ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

inline DoubleDouble operator+(DoubleDouble a, double b)
{
    const DoubleDouble s = two_sum(a.hi, b);
    return quick_two_sum(s.hi, s.lo + a.lo);
}

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble s = two_sum(a.hi, b.hi);
    return quick_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

inline DoubleDouble operator*(DoubleDouble a, double b)
{
    const DoubleDouble p = two_product(a.hi, b);
    return quick_two_sum(p.hi, p.lo + a.lo * b);
}

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble p = two_product(a.hi, b.hi);
    return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }
inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

// Two digits of long division, each corrected by what it leaves.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b)
{
    const double first = a.hi / b.hi;
    const DoubleDouble rest = a - b * first;
    return quick_two_sum(first, rest.hi / b.hi);
}

inline double rounded(DoubleDouble a) { return a.hi + a.lo; }

}  // namespace epode
