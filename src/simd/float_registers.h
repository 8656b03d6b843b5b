// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Computing with FloatLanes: all eight at once, in one vector with AVX2 and better, in two of four elsewhere.
// Operation by operation the same as for one lane, nothing fused, so the bits are those of every other
// machine. As in simd/vectors.h everything is in an unnamed namespace: one text compiled for several machines
// must not be merged by the linker.
#pragma once

#include "simd/float_lanes.h"
#include "simd/lanewise.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace epode {
namespace {

#if defined(__AVX2__)
constexpr int kFloatVector = 8;
#else
constexpr int kFloatVector = 4;
#endif
constexpr int kFloatVectors = kFloatLanes / kFloatVector;

typedef float FloatVector __attribute__((vector_size(kFloatVector * sizeof(float))));
typedef FloatVector FloatVectorInMemory __attribute__((may_alias));
typedef float QuadInMemory __attribute__((vector_size(4 * sizeof(float)), may_alias));

// n vectors side by side.
template <int n>
struct Floats {
    FloatVector v[n];
};
using Wide = Floats<kFloatVectors>;

EPODE_LANEWISE Wide load(const FloatLanes& x)
{
    const auto* from = reinterpret_cast<const FloatVectorInMemory*>(x.at);
    Wide out;
    for (int i = 0; i < kFloatVectors; ++i) out.v[i] = from[i];
    return out;
}

EPODE_LANEWISE void store(FloatLanes& x, const Wide& value)
{
    auto* to = reinterpret_cast<FloatVectorInMemory*>(x.at);
    for (int i = 0; i < kFloatVectors; ++i) to[i] = value.v[i];
}

template <int n>
EPODE_LANEWISE Floats<n> filled(float x)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = FloatVector{} + x;
    return out;
}

EPODE_LANEWISE Wide wide(float x) { return filled<kFloatVectors>(x); }

template <int n>
EPODE_LANEWISE Floats<n> operator+(const Floats<n>& x, const Floats<n>& y)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] + y.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> operator-(const Floats<n>& x, const Floats<n>& y)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] - y.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> operator*(const Floats<n>& x, const Floats<n>& y)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] * y.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> operator/(const Floats<n>& x, const Floats<n>& y)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] / y.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> operator-(const Floats<n>& x)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = -x.v[i];
    return out;
}

// Of these, x is the answer when the first argument is not a number.
template <int n>
EPODE_LANEWISE Floats<n> at_most(const Floats<n>& bound, const Floats<n>& x)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = bound.v[i] < x.v[i] ? bound.v[i] : x.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> at_least(const Floats<n>& bound, const Floats<n>& x)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = bound.v[i] > x.v[i] ? bound.v[i] : x.v[i];
    return out;
}

// test > 0 ? yes : no
template <int n>
EPODE_LANEWISE Floats<n> if_positive(const Floats<n>& test, const Floats<n>& yes, const Floats<n>& no)
{
    const FloatVector zero{};
    Floats<n> out;
    for (int i = 0; i < n; ++i) out.v[i] = test.v[i] > zero ? yes.v[i] : no.v[i];
    return out;
}

template <int n>
EPODE_LANEWISE Floats<n> square_root(const Floats<n>& x)
{
    Floats<n> out;
    for (int i = 0; i < n; ++i) {
#if defined(__AVX2__)
        out.v[i] = FloatVector(_mm256_sqrt_ps(__m256(x.v[i])));
#elif defined(__x86_64__)
        out.v[i] = FloatVector(_mm_sqrt_ps(__m128(x.v[i])));
#else
        for (int lane = 0; lane < kFloatVector; ++lane) out.v[i][lane] = __builtin_sqrtf(x.v[i][lane]);
#endif
    }
    return out;
}

template <int n>
struct Floats3 {
    Floats<n> x, y, z;
};
using Wide3 = Floats3<kFloatVectors>;

EPODE_LANEWISE Wide3 load(const FloatLaneVec3& a) { return {load(a.x), load(a.y), load(a.z)}; }

EPODE_LANEWISE void store(FloatLaneVec3& a, const Wide3& value)
{
    store(a.x, value.x), store(a.y, value.y), store(a.z, value.z);
}

template <int n>
EPODE_LANEWISE Floats3<n> operator+(const Floats3<n>& a, const Floats3<n>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <int n>
EPODE_LANEWISE Floats3<n> operator-(const Floats3<n>& a, const Floats3<n>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <int n>
EPODE_LANEWISE Floats3<n> operator*(const Floats<n>& s, const Floats3<n>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
template <int n>
EPODE_LANEWISE Floats<n> dot(const Floats3<n>& a, const Floats3<n>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int n>
EPODE_LANEWISE Floats3<n> cross(const Floats3<n>& a, const Floats3<n>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <int n>
struct FloatsSym3 {
    Floats<n> xx, yy, zz, xy, xz, yz;
};
using WideSym3 = FloatsSym3<kFloatVectors>;

EPODE_LANEWISE WideSym3 load(const FloatLaneSym3& s)
{
    return {load(s.xx), load(s.yy), load(s.zz), load(s.xy), load(s.xz), load(s.yz)};
}

template <int n>
EPODE_LANEWISE Floats3<n> operator*(const FloatsSym3<n>& s, const Floats3<n>& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

// Between four floats x, y, z, unused at the place of each lane, aligned as four, and one register per
// component: matrices of four by four are transposed, with AVX2 two at a time, lanes 0-3 beside lanes 4-7.
EPODE_LANEWISE FloatVector quad_at(const float* const* at, int i)
{
#if defined(__AVX2__)
    const auto low = *reinterpret_cast<const QuadInMemory*>(at[i]);
    const auto high = *reinterpret_cast<const QuadInMemory*>(at[i + 4]);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return *reinterpret_cast<const QuadInMemory*>(at[i]);
#endif
}

// Into the places of lane i, and i + 4 with AVX2, where `Keep` says nothing against it.
template <typename Keep>
EPODE_LANEWISE void put_quad(const FloatVector& value, float* const* at, const Keep& keep, int i)
{
#if defined(__AVX2__)
    if (!keep[i]) *reinterpret_cast<QuadInMemory*>(at[i]) = __builtin_shufflevector(value, value, 0, 1, 2, 3);
    if (!keep[i + 4])
        *reinterpret_cast<QuadInMemory*>(at[i + 4]) = __builtin_shufflevector(value, value, 4, 5, 6, 7);
#else
    if (!keep[i]) *reinterpret_cast<QuadInMemory*>(at[i]) = value;
#endif
}

#if defined(__AVX2__)
#define EPODE_LOW_PAIRS 0, 8, 1, 9, 4, 12, 5, 13
#define EPODE_HIGH_PAIRS 2, 10, 3, 11, 6, 14, 7, 15
#define EPODE_FIRST_HALVES 0, 1, 8, 9, 4, 5, 12, 13
#define EPODE_SECOND_HALVES 2, 3, 10, 11, 6, 7, 14, 15
#else
#define EPODE_LOW_PAIRS 0, 4, 1, 5
#define EPODE_HIGH_PAIRS 2, 6, 3, 7
#define EPODE_FIRST_HALVES 0, 1, 4, 5
#define EPODE_SECOND_HALVES 2, 3, 6, 7
#endif

template <int n = kFloatVectors>
EPODE_LANEWISE Floats3<n> gather_floats(const float* const* at)
{
    Floats3<n> out;
    for (int i = 0; i < n; ++i) {
        const float* const* p = at + i * kFloatVector;
        const FloatVector a = quad_at(p, 0), b = quad_at(p, 1), c = quad_at(p, 2), d = quad_at(p, 3);
        const FloatVector ab = __builtin_shufflevector(a, b, EPODE_LOW_PAIRS);  // xa xb ya yb
        const FloatVector cd = __builtin_shufflevector(c, d, EPODE_LOW_PAIRS);
        out.x.v[i] = __builtin_shufflevector(ab, cd, EPODE_FIRST_HALVES);
        out.y.v[i] = __builtin_shufflevector(ab, cd, EPODE_SECOND_HALVES);
        out.z.v[i] =
            __builtin_shufflevector(__builtin_shufflevector(a, b, EPODE_HIGH_PAIRS),
                                    __builtin_shufflevector(c, d, EPODE_HIGH_PAIRS), EPODE_FIRST_HALVES);
    }
    return out;
}

struct KeepNone {
    EPODE_LANEWISE constexpr bool operator[](int) const { return false; }
    EPODE_LANEWISE constexpr KeepNone operator+(int) const { return {}; }
};

// The unused fourth number becomes zero; places with `keep` are left alone.
template <int n, typename Keep>
EPODE_LANEWISE void scatter_floats(const Floats3<n>& value, float* const* at, const Keep& keep)
{
    const FloatVector zero{};
    for (int i = 0; i < n; ++i) {
        const FloatVector x = value.x.v[i], y = value.y.v[i], z = value.z.v[i];
        const FloatVector xy_low = __builtin_shufflevector(x, y, EPODE_LOW_PAIRS);  // x0 y0 x1 y1
        const FloatVector xy_high = __builtin_shufflevector(x, y, EPODE_HIGH_PAIRS);
        const FloatVector z_low = __builtin_shufflevector(z, zero, EPODE_LOW_PAIRS);
        const FloatVector z_high = __builtin_shufflevector(z, zero, EPODE_HIGH_PAIRS);
        float* const* p = at + i * kFloatVector;
        const auto k = keep + i * kFloatVector;
        put_quad(__builtin_shufflevector(xy_low, z_low, EPODE_FIRST_HALVES), p, k, 0);
        put_quad(__builtin_shufflevector(xy_low, z_low, EPODE_SECOND_HALVES), p, k, 1);
        put_quad(__builtin_shufflevector(xy_high, z_high, EPODE_FIRST_HALVES), p, k, 2);
        put_quad(__builtin_shufflevector(xy_high, z_high, EPODE_SECOND_HALVES), p, k, 3);
    }
}

}  // namespace
}  // namespace epode
