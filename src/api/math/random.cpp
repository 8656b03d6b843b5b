// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The functions of ODE's public generator (base/random.h) and the helpers of misc.h that test programs are
// written with; matrices there are padded by dPAD.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "ode/misc.h"

#include "base/check.h"
#include "base/random.h"
#include "math/dense.h"

using namespace epode;

namespace {

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
        s = ProcessRandom::following(s);
        if (s != expected) return 0;
    }
    return 1;
}

extern "C" unsigned long dRand(void) { return ProcessRandom::next(); }

extern "C" unsigned long dRandGetSeed(void) { return ProcessRandom::state(); }

extern "C" void dRandSetSeed(unsigned long s) { ProcessRandom::set_state(std::uint32_t(s)); }

extern "C" int dRandInt(int n) { return ProcessRandom::below(n); }

extern "C" dReal dRandReal(void) { return Real(double(ProcessRandom::next()) / 4294967295.0); }

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
