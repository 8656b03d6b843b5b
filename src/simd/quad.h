// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Four Reals at a time in vectors of 16 bytes, which every supported machine has: one vector of floats, two
// of doubles. For short work inside scalar code that needs one answer at once and not eight: the axes of a
// box, the corners of a face. Lanes never mix and nothing is fused, so the bits are those of the scalar
// formula. Wider vectors were rejected: kernels for other machines are selected by a call, which costs as
// much as they save. Everything is in an unnamed namespace for the reason given in simd/pack.h.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/config.h"
#include "simd/lanewise.h"

namespace epode {
namespace {

typedef Real QuadPart __attribute__((vector_size(16)));

#if defined(dIDESINGLE)
typedef std::int32_t QuadBits __attribute__((vector_size(16)));
constexpr std::int32_t kAllButSign = 0x7fffffff;

struct Quad {
    QuadPart x;
};
struct QuadMask {  // yes or no for each lane
    QuadBits x;
};

EPODE_LANEWISE Quad quad(Real a, Real b, Real c, Real d) { return {QuadPart{a, b, c, d}}; }
#define EPODE_QUAD_OPERATION(Result, name, expression)                                   \
    EPODE_LANEWISE Result name(const Quad& a, const Quad& b)                             \
    {                                                                                    \
        const auto on = [](const QuadPart& s, const QuadPart& t) { return expression; }; \
        return {on(a.x, b.x)};                                                           \
    }
EPODE_LANEWISE Real lane(const Quad& a, int i) { return a.x[i]; }
EPODE_LANEWISE Quad magnitude(const Quad& a)
{
    return {QuadPart(QuadBits(a.x) & (QuadBits{} + kAllButSign))};
}
EPODE_LANEWISE QuadMask operator|(const QuadMask& a, const QuadMask& b) { return {a.x | b.x}; }
#else
typedef std::int64_t QuadBits __attribute__((vector_size(16)));
constexpr std::int64_t kAllButSign = 0x7fffffffffffffff;

struct Quad {
    QuadPart x, y;
};
struct QuadMask {  // yes or no for each lane
    QuadBits x, y;
};

EPODE_LANEWISE Quad quad(Real a, Real b, Real c, Real d) { return {QuadPart{a, b}, QuadPart{c, d}}; }
#define EPODE_QUAD_OPERATION(Result, name, expression)                                   \
    EPODE_LANEWISE Result name(const Quad& a, const Quad& b)                             \
    {                                                                                    \
        const auto on = [](const QuadPart& s, const QuadPart& t) { return expression; }; \
        return {on(a.x, b.x), on(a.y, b.y)};                                             \
    }
EPODE_LANEWISE Real lane(const Quad& a, int i) { return i < 2 ? a.x[i] : a.y[i - 2]; }
EPODE_LANEWISE Quad magnitude(const Quad& a)
{
    const QuadBits keep = QuadBits{} + kAllButSign;
    return {QuadPart(QuadBits(a.x) & keep), QuadPart(QuadBits(a.y) & keep)};
}
EPODE_LANEWISE QuadMask operator|(const QuadMask& a, const QuadMask& b) { return {a.x | b.x, a.y | b.y}; }
#endif

EPODE_QUAD_OPERATION(Quad, operator+, s + t)
EPODE_QUAD_OPERATION(Quad, operator-, s - t)
EPODE_QUAD_OPERATION(Quad, operator*, s* t)
EPODE_QUAD_OPERATION(Quad, operator/, s / t)
EPODE_QUAD_OPERATION(Quad, smaller, s < t ? s : t)
EPODE_QUAD_OPERATION(Quad, larger, s > t ? s : t)
EPODE_QUAD_OPERATION(QuadMask, operator<, s < t)
EPODE_QUAD_OPERATION(QuadMask, operator<=, s <= t)
EPODE_QUAD_OPERATION(QuadMask, operator>, s > t)
#undef EPODE_QUAD_OPERATION

// a < b ? yes : no
EPODE_LANEWISE Quad if_less(const Quad& a, const Quad& b, const Quad& yes, const Quad& no)
{
#if defined(dIDESINGLE)
    return {a.x < b.x ? yes.x : no.x};
#else
    return {a.x < b.x ? yes.x : no.x, a.y < b.y ? yes.y : no.y};
#endif
}

// Not through memcpy, after which compilers keep a copy in memory.
typedef QuadPart QuadPartAnywhere __attribute__((aligned(sizeof(Real)), may_alias));
EPODE_LANEWISE Quad load_quad(const Real* p)
{
    const QuadPartAnywhere* parts = reinterpret_cast<const QuadPartAnywhere*>(p);
#if defined(dIDESINGLE)
    return {parts[0]};
#else
    return {parts[0], parts[1]};
#endif
}
EPODE_LANEWISE void store_quad(Real* p, const Quad& a)
{
    QuadPartAnywhere* parts = reinterpret_cast<QuadPartAnywhere*>(p);
    parts[0] = a.x;
#if !defined(dIDESINGLE)
    parts[1] = a.y;
#endif
}
EPODE_LANEWISE Quad quad(Real a) { return quad(a, a, a, a); }
// get(0) ... get(count - 1), one to four of them; missing ones repeat the last.
template <typename Get>
EPODE_LANEWISE Quad quad_of(int count, const Get& get)
{
    const int last = count - 1;
    return quad(get(0), get(last < 1 ? last : 1), get(last < 2 ? last : 2), get(last));
}

// Four floats, whatever Real is.
typedef float FloatQuad __attribute__((vector_size(16)));
#if defined(dIDESINGLE)
EPODE_LANEWISE Quad widen(const FloatQuad& a) { return {a}; }
EPODE_LANEWISE FloatQuad narrow(const Quad& a) { return a.x; }
#else
#if defined(__SSE2__) && !defined(__clang__)
// Widens the first two floats. GCC 12 converts pairs of floats one by one.
EPODE_LANEWISE QuadPart widen_pair(const FloatQuad& a) { return __builtin_ia32_cvtps2pd(a); }
EPODE_LANEWISE FloatQuad narrow_pair(const QuadPart& a) { return __builtin_ia32_cvtpd2ps(a); }
#else
typedef float FloatPair __attribute__((vector_size(8)));
EPODE_LANEWISE QuadPart widen_pair(const FloatQuad& a)
{
    return __builtin_convertvector(__builtin_shufflevector(a, a, 0, 1), QuadPart);
}
EPODE_LANEWISE FloatQuad narrow_pair(const QuadPart& a)
{
    const FloatPair pair = __builtin_convertvector(a, FloatPair);
    return __builtin_shufflevector(pair, pair, 0, 1, 0, 1);
}
#endif
EPODE_LANEWISE Quad widen(const FloatQuad& a)
{
    return {widen_pair(a), widen_pair(__builtin_shufflevector(a, a, 2, 3, 2, 3))};
}
EPODE_LANEWISE FloatQuad narrow(const Quad& a)
{
    return __builtin_shufflevector(narrow_pair(a.x), narrow_pair(a.y), 0, 1, 4, 5);
}
#endif
EPODE_LANEWISE FloatQuad load_floats(const float* p)
{
    FloatQuad a;
    __builtin_memcpy(&a, p, sizeof(a));
    return a;
}
EPODE_LANEWISE void store_floats(float* p, const FloatQuad& a) { __builtin_memcpy(p, &a, sizeof(a)); }
EPODE_LANEWISE void transpose(FloatQuad (&m)[4])
{
    const FloatQuad a = __builtin_shufflevector(m[0], m[1], 0, 4, 1, 5),
                    b = __builtin_shufflevector(m[0], m[1], 2, 6, 3, 7),
                    c = __builtin_shufflevector(m[2], m[3], 0, 4, 1, 5),
                    d = __builtin_shufflevector(m[2], m[3], 2, 6, 3, 7);
    m[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), m[1] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    m[2] = __builtin_shufflevector(b, d, 0, 1, 4, 5), m[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

EPODE_LANEWISE Quad square_root(const Quad& a)
{
#if defined(__SSE2__) && defined(dIDESINGLE)
    return {__builtin_ia32_sqrtps(a.x)};
#elif defined(__SSE2__)
    return {__builtin_ia32_sqrtpd(a.x), __builtin_ia32_sqrtpd(a.y)};
#else
    return quad(std::sqrt(lane(a, 0)), std::sqrt(lane(a, 1)), std::sqrt(lane(a, 2)), std::sqrt(lane(a, 3)));
#endif
}

// Lane 0 in the lowest bit.
EPODE_LANEWISE unsigned bits(const QuadMask& yes)
{
#if defined(__SSE2__) && defined(dIDESINGLE)
    return unsigned(__builtin_ia32_movmskps(QuadPart(yes.x)));
#elif defined(__SSE2__)
    return unsigned(__builtin_ia32_movmskpd(QuadPart(yes.x)) | __builtin_ia32_movmskpd(QuadPart(yes.y)) << 2);
#elif defined(dIDESINGLE)
    return unsigned((yes.x[0] & 1) | (yes.x[1] & 2) | (yes.x[2] & 4) | (yes.x[3] & 8));
#else
    return unsigned((yes.x[0] & 1) | (yes.x[1] & 2) | (yes.y[0] & 4) | (yes.y[1] & 8));
#endif
}

EPODE_LANEWISE Real largest_lane(const Quad& a)
{
    const Real u = lane(a, 0) > lane(a, 1) ? lane(a, 0) : lane(a, 1);
    const Real v = lane(a, 2) > lane(a, 3) ? lane(a, 2) : lane(a, 3);
    return u > v ? u : v;
}

}  // namespace
}  // namespace epode
