// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pack<T, N>: N numbers, one of each of N independent problems, in machine vectors. Every operation is the
// scalar one in each lane and nothing is fused, so the bits depend neither on N nor on the machine.
//
// A machine vector has 64 bytes in files compiled for AVX-512, 32 with AVX2, and the 16 that every supported
// machine has elsewhere (SSE2, NEON). A pack is one of them or two: a visit to a contact is one long
// dependency chain, and the execution units idle half of the time unless a second, independent chain runs in
// between.
//
// One text compiled for several machines must not be merged by the linker: everything here is in an unnamed
// namespace, and code for a better machine than the baseline calls no shared inline function at all.
#pragma once

#include "base/config.h"
#include "simd/lanewise.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace epode {
namespace {

#if defined(EPODE_VECTOR_BYTES)  // 64 in files that are compiled for AVX-512
constexpr int kVectorBytes = EPODE_VECTOR_BYTES;
#elif defined(__AVX2__)
constexpr int kVectorBytes = 32;
#else
constexpr int kVectorBytes = 16;
#endif

template <typename T, int N>
struct Pack {
    using Number = T;
    static constexpr int kLanes = N;
    static constexpr int kVectors = N * int(sizeof(T)) > kVectorBytes ? 2 : 1;
    static constexpr int kWidth = N / kVectors;  // lanes of a vector
    typedef T Vector __attribute__((vector_size(kWidth * sizeof(T))));
    static_assert(sizeof(Vector) <= kVectorBytes);

    Vector v[kVectors];

    Pack() = default;
    EPODE_LANEWISE explicit Pack(T x)
    {
        for (int i = 0; i < kVectors; ++i) v[i] = x - Vector{};
    }

    EPODE_LANEWISE T operator[](int lane) const { return v[lane / kWidth][lane % kWidth]; }
    EPODE_LANEWISE void set(int lane, T x) { v[lane / kWidth][lane % kWidth] = x; }

    EPODE_LANEWISE friend Pack operator+(const Pack& x, const Pack& y)
    {
        Pack out;
        out.v[0] = x.v[0] + y.v[0];
        if constexpr (kVectors > 1) out.v[1] = x.v[1] + y.v[1];
        return out;
    }

    EPODE_LANEWISE friend Pack operator-(const Pack& x, const Pack& y)
    {
        Pack out;
        out.v[0] = x.v[0] - y.v[0];
        if constexpr (kVectors > 1) out.v[1] = x.v[1] - y.v[1];
        return out;
    }

    EPODE_LANEWISE friend Pack operator*(const Pack& x, const Pack& y)
    {
        Pack out;
        out.v[0] = x.v[0] * y.v[0];
        if constexpr (kVectors > 1) out.v[1] = x.v[1] * y.v[1];
        return out;
    }

    EPODE_LANEWISE friend Pack operator/(const Pack& x, const Pack& y)
    {
        Pack out;
        out.v[0] = x.v[0] / y.v[0];
        if constexpr (kVectors > 1) out.v[1] = x.v[1] / y.v[1];
        return out;
    }

    EPODE_LANEWISE friend Pack operator-(const Pack& x)
    {
        Pack out;
        out.v[0] = -x.v[0];
        if constexpr (kVectors > 1) out.v[1] = -x.v[1];
        return out;
    }

    // If the first argument is NaN, these return x.
    EPODE_LANEWISE friend Pack at_most(const Pack& bound, const Pack& x)
    {
        Pack out;
        out.v[0] = bound.v[0] < x.v[0] ? bound.v[0] : x.v[0];
        if constexpr (kVectors > 1) out.v[1] = bound.v[1] < x.v[1] ? bound.v[1] : x.v[1];
        return out;
    }

    EPODE_LANEWISE friend Pack at_least(const Pack& bound, const Pack& x)
    {
        Pack out;
        out.v[0] = bound.v[0] > x.v[0] ? bound.v[0] : x.v[0];
        if constexpr (kVectors > 1) out.v[1] = bound.v[1] > x.v[1] ? bound.v[1] : x.v[1];
        return out;
    }

    // x > y ? yes : no
    EPODE_LANEWISE friend Pack if_greater(const Pack& x, const Pack& y, const Pack& yes, const Pack& no)
    {
        Pack out;
        out.v[0] = x.v[0] > y.v[0] ? yes.v[0] : no.v[0];
        if constexpr (kVectors > 1) out.v[1] = x.v[1] > y.v[1] ? yes.v[1] : no.v[1];
        return out;
    }

    // test > 0 ? yes : no
    EPODE_LANEWISE friend Pack if_positive(const Pack& test, const Pack& yes, const Pack& no)
    {
        Pack out;
        out.v[0] = test.v[0] > Vector{} ? yes.v[0] : no.v[0];
        if constexpr (kVectors > 1) out.v[1] = test.v[1] > Vector{} ? yes.v[1] : no.v[1];
        return out;
    }
};

template <typename T, int N>
EPODE_LANEWISE Pack<T, N> clip(const Pack<T, N>& x, const Pack<T, N>& lo, const Pack<T, N>& hi)
{
    return at_least(lo, at_most(hi, x));
}

template <typename T, int N>
EPODE_LANEWISE Pack<T, N> magnitude(const Pack<T, N>& x)
{
    return at_least(x, -x);
}

// 1 / x where that is above zero, else zero.
template <typename T, int N>
EPODE_LANEWISE Pack<T, N> inverse_or_zero(const Pack<T, N>& x)
{
    return if_positive(x, Pack<T, N>(1) / x, Pack<T, N>{});
}

// Signs of the lanes of a machine vector, or-ed: whether any is negative (or a negative zero or NaN).
template <typename V>
EPODE_LANEWISE bool any_sign(const V& x)
{
    [[maybe_unused]] constexpr bool kFloat = sizeof(x[0]) == sizeof(float);
#if defined(__AVX512F__)
    if constexpr (sizeof(V) == 64 && kFloat) return _mm512_movepi32_mask(__m512i(x)) != 0;
    if constexpr (sizeof(V) == 64 && !kFloat) return _mm512_movepi64_mask(__m512i(x)) != 0;
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(V) == 32 && kFloat) return _mm256_movemask_ps(__m256(x)) != 0;
    if constexpr (sizeof(V) == 32 && !kFloat) return _mm256_movemask_pd(__m256d(x)) != 0;
#endif
#if defined(__x86_64__)
    if constexpr (sizeof(V) == 16 && kFloat) return _mm_movemask_ps(__m128(x)) != 0;
    if constexpr (sizeof(V) == 16 && !kFloat) return _mm_movemask_pd(__m128d(x)) != 0;
#endif
    bool any = false;
    for (int lane = 0; lane < int(sizeof(V) / sizeof(x[0])); ++lane) any |= __builtin_signbit(x[lane]) != 0;
    return any;
}

template <typename T, int N>
EPODE_LANEWISE bool any_positive(const Pack<T, N>& x)
{
    using V = typename Pack<T, N>::Vector;
    bool any = false;
    for (int i = 0; i < Pack<T, N>::kVectors; ++i) any |= any_sign(V(x.v[i] > V{}));
    return any;
}

// Square roots are correctly rounded everywhere. Compilers make one instruction of the loop for doubles; of
// that for floats they do not. (Masked, because gcc 12 reports the unmasked intrinsic as a use of an
// uninitialised value.)
template <typename V>
EPODE_LANEWISE V root_of(const V& x)
{
#if defined(__AVX512F__)
    if constexpr (sizeof(V) == 64 && sizeof(x[0]) == sizeof(float))
        return V(_mm512_maskz_sqrt_ps(__mmask16(-1), __m512(x)));
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(V) == 32 && sizeof(x[0]) == sizeof(float)) return V(_mm256_sqrt_ps(__m256(x)));
#endif
#if defined(__x86_64__)
    if constexpr (sizeof(V) == 16 && sizeof(x[0]) == sizeof(float)) return V(_mm_sqrt_ps(__m128(x)));
#endif
    V out{};
    for (int lane = 0; lane < int(sizeof(V) / sizeof(x[0])); ++lane) out[lane] = __builtin_sqrt(x[lane]);
    return out;
}

template <typename T, int N>
EPODE_LANEWISE Pack<T, N> square_root(const Pack<T, N>& x)
{
    Pack<T, N> out;
    for (int i = 0; i < Pack<T, N>::kVectors; ++i) out.v[i] = root_of(x.v[i]);
    return out;
}

}  // namespace
}  // namespace epode
