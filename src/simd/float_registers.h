// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Arithmetic on lanes of floats: a vector holds eight of them with AVX2 and better, with AVX-512 also
// sixteen, elsewhere four; several vectors may stand side by side. Each operation is the same as for one lane
// and nothing is fused, so the bits are those of every other machine. As in simd/vectors.h everything is in
// an unnamed namespace: one text compiled for several machines must not be merged by the linker.
#pragma once

#include "simd/components.h"
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
typedef float FloatVector __attribute__((vector_size(kFloatVector * sizeof(float))));
typedef FloatVector FloatVectorInMemory __attribute__((may_alias));

#if defined(__AVX512F__)
constexpr int kBroadVector = 16;
typedef float BroadVector __attribute__((vector_size(kBroadVector * sizeof(float))));
typedef BroadVector BroadVectorInMemory __attribute__((may_alias));
#else
constexpr int kBroadVector = kFloatVector;
using BroadVector = FloatVector;
using BroadVectorInMemory = FloatVectorInMemory;
#endif

// Four neighbours in memory.
typedef float FloatRow __attribute__((vector_size(4 * sizeof(float))));
typedef FloatRow FloatRowInMemory __attribute__((may_alias));

// n vectors side by side.
template <typename V, int n>
struct Floats {
    V v[n];
};
template <typename V, int n>
EPODE_LANEWISE Floats<V, n> filled(float x)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = V{} + x;
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> operator+(const Floats<V, n>& x, const Floats<V, n>& y)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] + y.v[i];
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> operator-(const Floats<V, n>& x, const Floats<V, n>& y)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] - y.v[i];
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> operator*(const Floats<V, n>& x, const Floats<V, n>& y)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] * y.v[i];
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> operator/(const Floats<V, n>& x, const Floats<V, n>& y)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = x.v[i] / y.v[i];
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> operator-(const Floats<V, n>& x)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = -x.v[i];
    return out;
}

// If the first argument is NaN, these return x.
template <typename V, int n>
EPODE_LANEWISE Floats<V, n> at_most(const Floats<V, n>& bound, const Floats<V, n>& x)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = bound.v[i] < x.v[i] ? bound.v[i] : x.v[i];
    return out;
}

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> at_least(const Floats<V, n>& bound, const Floats<V, n>& x)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = bound.v[i] > x.v[i] ? bound.v[i] : x.v[i];
    return out;
}

// test > 0 ? yes : no
template <typename V, int n>
EPODE_LANEWISE Floats<V, n> if_positive(const Floats<V, n>& test, const Floats<V, n>& yes,
                                        const Floats<V, n>& no)
{
    const V zero{};
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = test.v[i] > zero ? yes.v[i] : no.v[i];
    return out;
}

EPODE_LANEWISE FloatVector root_of(const FloatVector& x)
{
#if defined(__AVX2__)
    return FloatVector(_mm256_sqrt_ps(__m256(x)));
#elif defined(__x86_64__)
    return FloatVector(_mm_sqrt_ps(__m128(x)));
#else
    FloatVector out;
    for (int lane = 0; lane < kFloatVector; ++lane) out[lane] = __builtin_sqrtf(x[lane]);
    return out;
#endif
}

#if defined(__AVX512F__)
// Masked, because gcc 12 reports the unmasked intrinsic as a use of an uninitialised value.
EPODE_LANEWISE BroadVector root_of(const BroadVector& x)
{
    return BroadVector(_mm512_maskz_sqrt_ps(__mmask16(-1), __m512(x)));
}
#endif

template <typename V, int n>
EPODE_LANEWISE Floats<V, n> square_root(const Floats<V, n>& x)
{
    Floats<V, n> out;
    for (int i = 0; i < n; ++i) out.v[i] = root_of(x.v[i]);
    return out;
}

template <typename V, int n>
struct Floats3 {
    Floats<V, n> x, y, z;
};
template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> operator+(const Floats3<V, n>& a, const Floats3<V, n>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> operator-(const Floats3<V, n>& a, const Floats3<V, n>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> operator*(const Floats<V, n>& s, const Floats3<V, n>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
template <typename V, int n>
EPODE_LANEWISE Floats<V, n> dot(const Floats3<V, n>& a, const Floats3<V, n>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> cross(const Floats3<V, n>& a, const Floats3<V, n>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename V, int n>
struct FloatsSym3 {
    Floats<V, n> xx, yy, zz, xy, xz, yz;
};
template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> operator*(const FloatsSym3<V, n>& s, const Floats3<V, n>& a)
{
    return {s.xx * a.x + s.xy * a.y + s.xz * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
            s.xz * a.x + s.yz * a.y + s.zz * a.z};
}

// Transposes rows of four. Rows lie in groups of four lanes of two vectors; in each group:
//   low_pairs a0 b0 a1 b1, high_pairs a2 b2 a3 b3, first_halves a0 a1 b0 b1, second_halves a2 a3 b2 b3.
#define EPODE_SHUFFLES(V, low, high, first, second)                                                        \
    EPODE_LANEWISE V low_pairs(const V& a, const V& b) { return __builtin_shufflevector(a, b, low); }      \
    EPODE_LANEWISE V high_pairs(const V& a, const V& b) { return __builtin_shufflevector(a, b, high); }    \
    EPODE_LANEWISE V first_halves(const V& a, const V& b) { return __builtin_shufflevector(a, b, first); } \
    EPODE_LANEWISE V second_halves(const V& a, const V& b) { return __builtin_shufflevector(a, b, second); }
#if defined(__AVX2__)
#define EPODE_LOW 0, 8, 1, 9, 4, 12, 5, 13
#define EPODE_HIGH 2, 10, 3, 11, 6, 14, 7, 15
#define EPODE_FIRST 0, 1, 8, 9, 4, 5, 12, 13
#define EPODE_SECOND 2, 3, 10, 11, 6, 7, 14, 15
#else
#define EPODE_LOW 0, 4, 1, 5
#define EPODE_HIGH 2, 6, 3, 7
#define EPODE_FIRST 0, 1, 4, 5
#define EPODE_SECOND 2, 3, 6, 7
#endif
EPODE_SHUFFLES(FloatVector, EPODE_LOW, EPODE_HIGH, EPODE_FIRST, EPODE_SECOND)
#if defined(__AVX512F__)
#define EPODE_BROAD_LOW 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29
#define EPODE_BROAD_HIGH 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31
#define EPODE_BROAD_FIRST 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29
#define EPODE_BROAD_SECOND 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31
EPODE_SHUFFLES(BroadVector, EPODE_BROAD_LOW, EPODE_BROAD_HIGH, EPODE_BROAD_FIRST, EPODE_BROAD_SECOND)
#endif

// row(i); with wider vectors row(i + 4) follows it, then row(i + 8) and row(i + 12).
template <typename Row>
EPODE_LANEWISE FloatVector rows_at(const FloatVector*, const Row& row, int i)
{
#if defined(__AVX2__)
    return __builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7);
#else
    return row(i);
#endif
}

// The inverse: put(i, row).
template <typename Put>
EPODE_LANEWISE void put_rows_at(const FloatVector& rows, const Put& put, int i)
{
#if defined(__AVX2__)
    put(i, __builtin_shufflevector(rows, rows, 0, 1, 2, 3));
    put(i + 4, __builtin_shufflevector(rows, rows, 4, 5, 6, 7));
#else
    put(i, rows);
#endif
}

#if defined(__AVX512F__)
template <typename Row>
EPODE_LANEWISE BroadVector rows_at(const BroadVector*, const Row& row, int i)
{
    const FloatVector* eight = nullptr;
    return __builtin_shufflevector(rows_at(eight, row, i), rows_at(eight, row, i + 8), 0, 1, 2, 3, 4, 5, 6, 7,
                                   8, 9, 10, 11, 12, 13, 14, 15);
}

template <typename Put>
EPODE_LANEWISE void put_rows_at(const BroadVector& rows, const Put& put, int i)
{
    put_rows_at(__builtin_shufflevector(rows, rows, 0, 1, 2, 3, 4, 5, 6, 7), put, i);
    put_rows_at(__builtin_shufflevector(rows, rows, 8, 9, 10, 11, 12, 13, 14, 15), put, i + 8);
}
#endif

// `row(lane)` is a FloatRow; one vector per component.
template <typename V, typename Row>
EPODE_LANEWISE Vector4Of<V> columns_of(const Row& row)
{
    const V* kind = nullptr;
    const V a = rows_at(kind, row, 0), b = rows_at(kind, row, 1), c = rows_at(kind, row, 2),
            d = rows_at(kind, row, 3);
    const V ab_low = low_pairs(a, b), cd_low = low_pairs(c, d);  // aw bw ax bx
    const V ab_high = high_pairs(a, b), cd_high = high_pairs(c, d);
    return {first_halves(ab_low, cd_low), second_halves(ab_low, cd_low), first_halves(ab_high, cd_high),
            second_halves(ab_high, cd_high)};
}

// put(lane, row) for each lane of a vector of x, y, z, and zero behind them.
template <typename V, typename Put>
EPODE_LANEWISE void put_rows(const Vector3Of<V>& v, const Put& put)
{
    const V zero{};
    const V xy_low = low_pairs(v.x, v.y), xy_high = high_pairs(v.x, v.y);  // x0 y0 x1 y1
    const V z_low = low_pairs(v.z, zero), z_high = high_pairs(v.z, zero);
    put_rows_at(first_halves(xy_low, z_low), put, 0);
    put_rows_at(second_halves(xy_low, z_low), put, 1);
    put_rows_at(first_halves(xy_high, z_high), put, 2);
    put_rows_at(second_halves(xy_high, z_high), put, 3);
}

// The same of n vectors side by side.
template <typename V, int n>
struct Floats4 {
    Floats<V, n> w, x, y, z;
};

template <typename V, int n, typename Row>
EPODE_LANEWISE Floats4<V, n> columns_side_by_side(const Row& row)
{
    Floats4<V, n> out;
    for (int i = 0; i < n; ++i) {
        const int first = i * int(sizeof(V) / sizeof(float));
        const auto of =
            columns_of<V>([=](int lane) EPODE_INLINE_LAMBDA -> FloatRow { return row(first + lane); });
        out.w.v[i] = of.w, out.x.v[i] = of.x, out.y.v[i] = of.y, out.z.v[i] = of.z;
    }
    return out;
}

// Four floats x, y, z, unused at the place of each lane, aligned as four.
template <typename V, int n>
EPODE_LANEWISE Floats3<V, n> gather_floats(const float* const* at)
{
    const auto of = columns_side_by_side<V, n>([=](int lane) EPODE_INLINE_LAMBDA -> FloatRow {
        return *reinterpret_cast<const FloatRowInMemory*>(at[lane]);
    });
    return {of.w, of.x, of.y};
}

struct KeepNone {
    EPODE_LANEWISE constexpr bool operator[](int) const { return false; }
    EPODE_LANEWISE constexpr KeepNone operator+(int) const { return {}; }
};

// The unused fourth number becomes zero. Addresses with `keep` are not written.
template <typename V, int n, typename Keep>
EPODE_LANEWISE void scatter_floats(const Floats3<V, n>& value, float* const* at, const Keep& keep)
{
    for (int i = 0; i < n; ++i) {
        float* const* p = at + i * int(sizeof(V) / sizeof(float));
        const auto k = keep + i * int(sizeof(V) / sizeof(float));
        put_rows(Vector3Of<V>{value.x.v[i], value.y.v[i], value.z.v[i]},
                 [=](int lane, const FloatRow& row) EPODE_INLINE_LAMBDA {
                     if (!k[lane]) *reinterpret_cast<FloatRowInMemory*>(p[lane]) = row;
                 });
    }
}

}  // namespace
}  // namespace epode
