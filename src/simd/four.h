// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Four doubles at a time, whatever Real is: one vector of 32 bytes with AVX2, two of 16 bytes elsewhere. As
// in simd/pack.h nothing is fused and sums over lanes have one order, so the bits do not depend on the
// width. Everything is in an unnamed namespace, so that the linker cannot merge what was compiled for
// different machines.
#pragma once

#include "simd/lanewise.h"

namespace epode {
namespace {

typedef double TwoInMemory __attribute__((vector_size(16), aligned(8), may_alias));

#if defined(__AVX2__)
typedef double FourVector __attribute__((vector_size(32)));
typedef double FourInMemory __attribute__((vector_size(32), aligned(8), may_alias));

struct Four {
    FourVector x;
};

EPODE_LANEWISE Four load_four(const double* p) { return {*reinterpret_cast<const FourInMemory*>(p)}; }
EPODE_LANEWISE void store_four(double* p, const Four& a) { *reinterpret_cast<FourInMemory*>(p) = a.x; }
EPODE_LANEWISE Four four(double a) { return {FourVector{a, a, a, a}}; }
EPODE_LANEWISE Four operator+(const Four& a, const Four& b) { return {a.x + b.x}; }
EPODE_LANEWISE Four operator-(const Four& a, const Four& b) { return {a.x - b.x}; }
EPODE_LANEWISE Four operator*(const Four& a, const Four& b) { return {a.x * b.x}; }
EPODE_LANEWISE Four operator/(const Four& a, const Four& b) { return {a.x / b.x}; }
EPODE_LANEWISE Four smaller(const Four& a, const Four& b) { return {a.x < b.x ? a.x : b.x}; }
EPODE_LANEWISE Four larger(const Four& a, const Four& b) { return {a.x > b.x ? a.x : b.x}; }

// a > b ? yes : no
EPODE_LANEWISE Four if_larger(const Four& a, const Four& b, const Four& yes, const Four& no)
{
    return {a.x > b.x ? yes.x : no.x};
}

// The sums (l0 + l1) + (l2 + l3) over the lanes of four vectors.
EPODE_LANEWISE Four lane_sums(const Four& a, const Four& b, const Four& c, const Four& d)
{
    const FourVector ab =
        __builtin_shufflevector(a.x, b.x, 0, 4, 2, 6) + __builtin_shufflevector(a.x, b.x, 1, 5, 3, 7);
    const FourVector cd =
        __builtin_shufflevector(c.x, d.x, 0, 4, 2, 6) + __builtin_shufflevector(c.x, d.x, 1, 5, 3, 7);
    return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7)};
}
#else
typedef double TwoVector __attribute__((vector_size(16)));

struct Four {
    TwoVector x, y;
};

EPODE_LANEWISE Four load_four(const double* p)
{
    const TwoInMemory* from = reinterpret_cast<const TwoInMemory*>(p);
    return {from[0], from[1]};
}

EPODE_LANEWISE void store_four(double* p, const Four& a)
{
    TwoInMemory* to = reinterpret_cast<TwoInMemory*>(p);
    to[0] = a.x, to[1] = a.y;
}

EPODE_LANEWISE Four four(double a) { return {TwoVector{a, a}, TwoVector{a, a}}; }
EPODE_LANEWISE Four operator+(const Four& a, const Four& b) { return {a.x + b.x, a.y + b.y}; }
EPODE_LANEWISE Four operator-(const Four& a, const Four& b) { return {a.x - b.x, a.y - b.y}; }
EPODE_LANEWISE Four operator*(const Four& a, const Four& b) { return {a.x * b.x, a.y * b.y}; }
EPODE_LANEWISE Four operator/(const Four& a, const Four& b) { return {a.x / b.x, a.y / b.y}; }

EPODE_LANEWISE Four smaller(const Four& a, const Four& b)
{
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y};
}

EPODE_LANEWISE Four larger(const Four& a, const Four& b)
{
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y};
}

EPODE_LANEWISE Four if_larger(const Four& a, const Four& b, const Four& yes, const Four& no)
{
    return {a.x > b.x ? yes.x : no.x, a.y > b.y ? yes.y : no.y};
}

EPODE_LANEWISE Four lane_sums(const Four& a, const Four& b, const Four& c, const Four& d)
{
    const auto pair = [](const TwoVector& s, const TwoVector& t) {
        return __builtin_shufflevector(s, t, 0, 2) + __builtin_shufflevector(s, t, 1, 3);
    };
    return {pair(a.x, b.x) + pair(a.y, b.y), pair(c.x, d.x) + pair(c.y, d.y)};
}
#endif

EPODE_LANEWISE Four operator-(const Four& a) { return four(0) - a; }
EPODE_LANEWISE Four magnitude(const Four& a) { return larger(a, -a); }

EPODE_LANEWISE double lane_sum(const Four& a)
{
    double x[4];
    store_four(x, a);
    return (x[0] + x[1]) + (x[2] + x[3]);
}

EPODE_LANEWISE double lane_maximum(const Four& a)
{
    double x[4];
    store_four(x, a);
    const double u = x[0] > x[1] ? x[0] : x[1], v = x[2] > x[3] ? x[2] : x[3];
    return u > v ? u : v;
}

}  // namespace
}  // namespace epode
