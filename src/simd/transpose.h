// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of four neighbouring numbers, one at the address of each lane, become columns: one machine vector V for
// each of the four. Small matrices are transposed for that, instead of moving number by number.
#pragma once

#include "base/config.h"
#include "simd/lanewise.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace epode {
namespace {

template <typename T>
struct RowOf {
    typedef T Type __attribute__((vector_size(4 * sizeof(T))));
};
using FloatRow = RowOf<float>::Type;
using RealRow = RowOf<Real>::Type;

template <typename V>
struct Columns {
    V a, b, c, d;
};

// Through memcpy, because vector types lose a smaller alignment when they pass through references and
// templates.
template <typename V, typename T>
EPODE_LANEWISE V vector_at(const T* from)
{
    V out;
    __builtin_memcpy(&out, from, sizeof out);
    return out;
}

template <typename V, typename T>
EPODE_LANEWISE void put_vector(T* to, const V& value)
{
    __builtin_memcpy(to, &value, sizeof value);
}

EPODE_LANEWISE FloatRow float_row_at(const float* from) { return vector_at<FloatRow>(from); }

// Four Reals a - b, rounded. (A function that returned them would need registers that not every machine has.)
EPODE_LANEWISE FloatRow float_difference(const Real* a, const Real* b)
{
    RealRow x, y;
    __builtin_memcpy(&x, a, sizeof x);
    __builtin_memcpy(&y, b, sizeof y);
    return __builtin_convertvector(x - y, FloatRow);
}

#if !defined(dIDESINGLE)
EPODE_LANEWISE FloatRow float_row_at(const Real* from)
{
    RealRow row;
    __builtin_memcpy(&row, from, sizeof row);
    return __builtin_convertvector(row, FloatRow);
}
#endif

// Adds to four Reals. Compilers make two conversions and a detour through memory of this, where one
// instruction is enough.
EPODE_LANEWISE void add_row(const FloatRow& change, Real* to)
{
    RealRow row;
    __builtin_memcpy(&row, to, sizeof row);
#if defined(__AVX2__) && !defined(dIDESINGLE)
    row = row + RealRow(_mm256_cvtps_pd(__m128(change)));
#else
    row = row + __builtin_convertvector(change, RealRow);
#endif
    __builtin_memcpy(to, &row, sizeof row);
}

template <typename V>
constexpr int kLanesIn = sizeof(V) / sizeof(V{}[0]);

// In each group of four lanes: those lanes of x (0 to 3) and y (4 to 7).
template <int a, int b, int c, int d, typename V>
EPODE_LANEWISE V in_fours(const V& x, const V& y)
{
    constexpr int n = kLanesIn<V>;
    constexpr auto at = [](int i, int group) { return 4 * group + (i < 4 ? i : n + i - 4); };
    if constexpr (n == 4)
        return __builtin_shufflevector(x, y, a, b, c, d);
    else if constexpr (n == 8)
        return __builtin_shufflevector(x, y, at(a, 0), at(b, 0), at(c, 0), at(d, 0), at(a, 1), at(b, 1),
                                       at(c, 1), at(d, 1));
    else
        return __builtin_shufflevector(x, y, at(a, 0), at(b, 0), at(c, 0), at(d, 0), at(a, 1), at(b, 1),
                                       at(c, 1), at(d, 1), at(a, 2), at(b, 2), at(c, 2), at(d, 2), at(a, 3),
                                       at(b, 3), at(c, 3), at(d, 3));
}

// Floats: row i and, in wider vectors, those of i + 4, i + 8, i + 12.
template <typename V, typename Row>
EPODE_LANEWISE V float_rows(const Row& row, int i)
{
    if constexpr (kLanesIn<V> == 4)
        return row(i);
    else if constexpr (kLanesIn<V> == 8)
        return __builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7);
    else {
        typedef float Half __attribute__((vector_size(32)));
        return __builtin_shufflevector(float_rows<Half>(row, i), float_rows<Half>(row, i + 8), 0, 1, 2, 3, 4,
                                       5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    }
}

template <typename V, typename Put>
EPODE_LANEWISE void put_float_rows(const V& rows, const Put& put, int i)
{
    if constexpr (kLanesIn<V> == 4)
        put(i, rows);
    else if constexpr (kLanesIn<V> == 8) {
        put(i, __builtin_shufflevector(rows, rows, 0, 1, 2, 3));
        put(i + 4, __builtin_shufflevector(rows, rows, 4, 5, 6, 7));
    } else {
        put_float_rows(__builtin_shufflevector(rows, rows, 0, 1, 2, 3, 4, 5, 6, 7), put, i);
        put_float_rows(__builtin_shufflevector(rows, rows, 8, 9, 10, 11, 12, 13, 14, 15), put, i + 8);
    }
}

template <typename V>
EPODE_LANEWISE Columns<V> transposed_floats(const Columns<V>& m)
{
    const V ab_low = in_fours<0, 4, 1, 5>(m.a, m.b), cd_low = in_fours<0, 4, 1, 5>(m.c, m.d);  // a0 b0 a1 b1
    const V ab_high = in_fours<2, 6, 3, 7>(m.a, m.b), cd_high = in_fours<2, 6, 3, 7>(m.c, m.d);
    return {in_fours<0, 1, 4, 5>(ab_low, cd_low), in_fours<2, 3, 6, 7>(ab_low, cd_low),
            in_fours<0, 1, 4, 5>(ab_high, cd_high), in_fours<2, 3, 6, 7>(ab_high, cd_high)};
}

// put(lane, FloatRow) for each lane.
template <typename V, typename Put>
EPODE_LANEWISE void for_each_row(const Columns<V>& columns, const Put& put)
{
    const Columns<V> rows = transposed_floats(columns);
    put_float_rows(rows.a, put, 0), put_float_rows(rows.b, put, 1);
    put_float_rows(rows.c, put, 2), put_float_rows(rows.d, put, 3);
}

// Two matrices of four by four side by side.
template <typename V>
EPODE_LANEWISE Columns<V> transposed_doubles(const Columns<V>& m)
{
    const V ab02 = __builtin_shufflevector(m.a, m.b, 0, 8, 2, 10, 4, 12, 6, 14);
    const V ab13 = __builtin_shufflevector(m.a, m.b, 1, 9, 3, 11, 5, 13, 7, 15);
    const V cd02 = __builtin_shufflevector(m.c, m.d, 0, 8, 2, 10, 4, 12, 6, 14);
    const V cd13 = __builtin_shufflevector(m.c, m.d, 1, 9, 3, 11, 5, 13, 7, 15);
    return {__builtin_shufflevector(ab02, cd02, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab13, cd13, 0, 1, 8, 9, 4, 5, 12, 13),
            __builtin_shufflevector(ab02, cd02, 2, 3, 10, 11, 6, 7, 14, 15),
            __builtin_shufflevector(ab13, cd13, 2, 3, 10, 11, 6, 7, 14, 15)};
}

typedef double DoublePair __attribute__((vector_size(16)));
using DoubleRow = RowOf<double>::Type;

// at(lane): where the row is. Halves of rows are joined from memory, which costs no shuffle.
template <typename V, typename At>
EPODE_LANEWISE Columns<V> double_columns(const At& at)
{
    const auto half = [&](int lane, int from)
                          EPODE_INLINE_LAMBDA { return vector_at<DoublePair>(at(lane) + from); };
    if constexpr (kLanesIn<V> == 2) {
        const DoublePair ab0 = half(0, 0), ab1 = half(1, 0), cd0 = half(0, 2), cd1 = half(1, 2);
        return {__builtin_shufflevector(ab0, ab1, 0, 2), __builtin_shufflevector(ab0, ab1, 1, 3),
                __builtin_shufflevector(cd0, cd1, 0, 2), __builtin_shufflevector(cd0, cd1, 1, 3)};
    } else if constexpr (kLanesIn<V> == 4) {
        const auto join = [&](int lane, int from) EPODE_INLINE_LAMBDA {
            return __builtin_shufflevector(half(lane, from), half(lane + 2, from), 0, 1, 2, 3);
        };
        const V ab02 = join(0, 0), ab13 = join(1, 0), cd02 = join(0, 2), cd13 = join(1, 2);
        return {
            __builtin_shufflevector(ab02, ab13, 0, 4, 2, 6), __builtin_shufflevector(ab02, ab13, 1, 5, 3, 7),
            __builtin_shufflevector(cd02, cd13, 0, 4, 2, 6), __builtin_shufflevector(cd02, cd13, 1, 5, 3, 7)};
    } else {
        const auto join = [&](int lane) EPODE_INLINE_LAMBDA {
            return __builtin_shufflevector(vector_at<DoubleRow>(at(lane)), vector_at<DoubleRow>(at(lane + 4)),
                                           0, 1, 2, 3, 4, 5, 6, 7);
        };
        return transposed_doubles<V>({join(0), join(1), join(2), join(3)});
    }
}

// at(lane): where to write the row.
template <typename V, typename At>
EPODE_LANEWISE void put_double_columns(const Columns<V>& m, const At& at)
{
    if constexpr (kLanesIn<V> == 2) {
        put_vector(at(0), __builtin_shufflevector(m.a, m.b, 0, 2));
        put_vector(at(1), __builtin_shufflevector(m.a, m.b, 1, 3));
        put_vector(at(0) + 2, __builtin_shufflevector(m.c, m.d, 0, 2));
        put_vector(at(1) + 2, __builtin_shufflevector(m.c, m.d, 1, 3));
    } else if constexpr (kLanesIn<V> == 4) {
        const V ab02 = __builtin_shufflevector(m.a, m.b, 0, 4, 2, 6);
        const V ab13 = __builtin_shufflevector(m.a, m.b, 1, 5, 3, 7);
        const V cd02 = __builtin_shufflevector(m.c, m.d, 0, 4, 2, 6);
        const V cd13 = __builtin_shufflevector(m.c, m.d, 1, 5, 3, 7);
        put_vector(at(0), __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5));
        put_vector(at(1), __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5));
        put_vector(at(2), __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7));
        put_vector(at(3), __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7));
    } else {
        const Columns<V> rows = transposed_doubles(m);
        const auto split = [&](int lane, const V& two) EPODE_INLINE_LAMBDA {
            put_vector(at(lane), __builtin_shufflevector(two, two, 0, 1, 2, 3));
            put_vector(at(lane + 4), __builtin_shufflevector(two, two, 4, 5, 6, 7));
        };
        split(0, rows.a), split(1, rows.b), split(2, rows.c), split(3, rows.d);
    }
}

}  // namespace
}  // namespace epode
