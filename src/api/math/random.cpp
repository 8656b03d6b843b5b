// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's public generator: s' = 1664525 s + 1013904223 mod 2^32 (Knuth & Lewis, in Press et al., "Numerical
// Recipes"), kept because clients rely on the very sequence. One state for the process, here an atomic, so
// that threads that draw at once get different numbers. Our solvers do not use it (base/random.h). With it
// the helpers of misc.h that test programs are written with; matrices there are padded by dPAD.
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "ode/misc.h"

#include "base/check.h"
#include "math/dense.h"

using namespace epode;

namespace {

std::atomic<std::uint32_t> g_state{0};

constexpr std::uint32_t following(std::uint32_t s) { return 1664525u * s + 1013904223u; }

std::uint32_t draw()
{
    std::uint32_t s = g_state.load(std::memory_order_relaxed);
    while (!g_state.compare_exchange_weak(s, following(s), std::memory_order_relaxed)) {}
    return following(s);
}

// In [0, n) for n > 0. The poor low bits of the generator are folded into the high ones until as many
// bits are left as n needs; ODE's clients see this exact choice.
std::uint32_t fold(std::uint32_t r, std::uint32_t n)
{
    if (n > 0x10000) return std::uint32_t(std::uint64_t(r) * n >> 32);
    r ^= r >> 16;
    if (n > 0x100) return (r & 0xffff) * n >> 16;
    r ^= r >> 8;
    if (n > 0x10) return (r & 0xff) * n >> 8;
    r ^= r >> 4;
    if (n > 4) return (r & 0xf) * n >> 4;
    r ^= r >> 2;
    if (n > 2) return (r & 3) * n >> 2;
    r ^= r >> 1;
    return r & (n >> 1);
}

Real draw_in(Real range) { return (dRandReal() * 2 - 1) * range; }

const char* skip_digits(const char* s, int max_digits)
{
    for (int i = 0; i < max_digits && *s >= '0' && *s <= '9'; ++i) ++s;
    return s;
}

// A format that printf can be given together with one double: at most one conversion, of a floating type,
// with width and precision of at most three digits that it states itself.
bool prints_a_number(const char* format)
{
    int conversions = 0;
    for (const char* s = format; *s; ++s) {
        if (*s != '%') continue;
        if (*++s == '%') continue;
        while (*s && std::strchr("-+ #0", *s)) ++s;
        s = skip_digits(s, 3);
        if (*s == '.') s = skip_digits(s + 1, 3);
        if (!*s || !std::strchr("eEfFgGaA", *s) || ++conversions > 1) return false;
    }
    return true;
}

}  // namespace

extern "C" int dTestRand(void)
{
    static constexpr std::uint32_t kExpected[] = {0x3c6ef35f, 0x47502932, 0xd1ccf6e9, 0xaaf95334, 0x6252e503};
    std::uint32_t s = 0;
    for (std::uint32_t expected : kExpected) {
        s = following(s);
        if (s != expected) return 0;
    }
    return 1;
}

extern "C" unsigned long dRand(void) { return draw(); }

extern "C" unsigned long dRandGetSeed(void) { return g_state.load(std::memory_order_relaxed); }

extern "C" void dRandSetSeed(unsigned long s) { g_state.store(std::uint32_t(s), std::memory_order_relaxed); }

extern "C" int dRandInt(int n)
{
    const std::uint32_t r = draw();  // drawn for n <= 1 too, as in ODE
    return n > 0 ? int(fold(r, std::uint32_t(n))) : 0;
}

extern "C" dReal dRandReal(void) { return Real(double(draw()) / 4294967295.0); }

extern "C" void dPrintMatrix(const dReal* A, int n, int m, const char* fmt, FILE* f)
{
    EPODE_USER(A && fmt && f && prints_a_number(fmt));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) std::fprintf(f, fmt, double(row_of(A, i, padded(m))[j]));
        std::fputc('\n', f);
    }
}

extern "C" void dMakeRandomVector(dReal* A, int n, dReal range)
{
    EPODE_USER(A && usable(range));
    for (int i = 0; i < n; ++i) A[i] = draw_in(range);
}

extern "C" void dMakeRandomMatrix(dReal* A, int n, int m, dReal range)
{
    EPODE_USER(A && usable(range));
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) row_of(A, i, padded(m))[j] = draw_in(range);
}

extern "C" void dClearUpperTriangle(dReal* A, int n)
{
    EPODE_USER(A);
    for (int i = 0; i < n; ++i)
        for (int j = i + 1; j < n; ++j) row_of(A, i, padded(n))[j] = 0;
}

extern "C" dReal dMaxDifference(const dReal* A, const dReal* B, int n, int m)
{
    EPODE_USER(A && B, 0);
    Real worst = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j)
            worst = std::fmax(worst, std::fabs(row_of(A, i, padded(m))[j] - row_of(B, i, padded(m))[j]));
    return worst;
}

extern "C" dReal dMaxDifferenceLowerTriangle(const dReal* A, const dReal* B, int n)
{
    EPODE_USER(A && B, 0);
    Real worst = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j)
            worst = std::fmax(worst, std::fabs(row_of(A, i, padded(n))[j] - row_of(B, i, padded(n))[j]));
    return worst;
}
