// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Six doubles in the registers of the machine that this is compiled for: what a body or a joint has of something, linear and angular.
// Every sum has one order on every machine: elements add up as (0 + 2) + 4 and (1 + 3) + 5, then both.
#pragma once

#include "simd/lanewise.h"

namespace epode {
namespace {

typedef double Two __attribute__((vector_size(16)));
typedef double TwoInMemory __attribute__((vector_size(16), aligned(8), may_alias));
typedef long long TwoBits __attribute__((vector_size(16)));

EPODE_LANEWISE Two load2(const double* p) { return *reinterpret_cast<const TwoInMemory*>(p); }
EPODE_LANEWISE void store2(double* p, Two x) { *reinterpret_cast<TwoInMemory*>(p) = x; }

#if defined(__AVX2__)
typedef double Four __attribute__((vector_size(32)));
typedef double FourInMemory __attribute__((vector_size(32), aligned(8), may_alias));
typedef long long FourBits __attribute__((vector_size(32)));

EPODE_LANEWISE Four load4(const double* p) { return *reinterpret_cast<const FourInMemory*>(p); }
EPODE_LANEWISE void store4(double* p, Four x) { *reinterpret_cast<FourInMemory*>(p) = x; }

struct Six {
    Four a;
    Two b;

    double operator[](int i) const { return i < 4 ? a[i] : b[i - 4]; }
};

EPODE_LANEWISE Six load6(const double* p) { return {load4(p), load2(p + 4)}; }
EPODE_LANEWISE void store6(double* p, const Six& x) { store4(p, x.a), store2(p + 4, x.b); }
// Number by number: where they have just been stored so, a vector would wait for these stores.
EPODE_LANEWISE Six gather6(const double* x) { return {Four{x[0], x[1], x[2], x[3]}, Two{x[4], x[5]}}; }
EPODE_LANEWISE Six operator+(const Six& x, const Six& y) { return {x.a + y.a, x.b + y.b}; }
EPODE_LANEWISE Six operator-(const Six& x, const Six& y) { return {x.a - y.a, x.b - y.b}; }
EPODE_LANEWISE Six operator*(const Six& x, const Six& y) { return {x.a * y.a, x.b * y.b}; }
EPODE_LANEWISE Six operator*(const Six& x, double s) { return {x.a * s, x.b * s}; }
EPODE_LANEWISE Two halves(const Six& x)
{
    return __builtin_shufflevector(x.a, x.a, 0, 1) + __builtin_shufflevector(x.a, x.a, 2, 3) + x.b;
}
#else
struct Six {
    Two a, b, c;

    double operator[](int i) const { return i < 2 ? a[i] : i < 4 ? b[i - 2] : c[i - 4]; }
};

EPODE_LANEWISE Six load6(const double* p) { return {load2(p), load2(p + 2), load2(p + 4)}; }
EPODE_LANEWISE void store6(double* p, const Six& x)
{
    store2(p, x.a), store2(p + 2, x.b), store2(p + 4, x.c);
}
EPODE_LANEWISE Six gather6(const double* x) { return {Two{x[0], x[1]}, Two{x[2], x[3]}, Two{x[4], x[5]}}; }
EPODE_LANEWISE Six operator+(const Six& x, const Six& y) { return {x.a + y.a, x.b + y.b, x.c + y.c}; }
EPODE_LANEWISE Six operator-(const Six& x, const Six& y) { return {x.a - y.a, x.b - y.b, x.c - y.c}; }
EPODE_LANEWISE Six operator*(const Six& x, const Six& y) { return {x.a * y.a, x.b * y.b, x.c * y.c}; }
EPODE_LANEWISE Six operator*(const Six& x, double s) { return {x.a * s, x.b * s, x.c * s}; }
EPODE_LANEWISE Two halves(const Six& x) { return x.a + x.b + x.c; }
#endif

EPODE_LANEWISE double sum(const Six& x)
{
    const Two s = halves(x);
    return s[0] + s[1];
}

}  // namespace
}  // namespace epode
