// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The linear algebra that ODE exports, over math/dense, cholesky and ldlt. Matrices are padded by dPAD unless
// a stride is given. Sizes and pointers are checked; the numbers are the client's. What ODE asserts with
// "Bad argument(s)" is refused with the same words, and so is what makes it crash.
#include "ode/matrix.h"

#include <algorithm>

#include "base/check.h"
#include "base/float_environment.h"
#include "math/cholesky.h"
#include "math/ldlt.h"
#include "math/scratch.h"

using namespace epode;

namespace {

// A stride may be anything for a single row.
bool fits(int n, int stride) { return n > 0 && (stride >= n || n == 1); }

}  // namespace

extern "C" void dSetZero(dReal* a, int n)
{
    EPODE_USER(n == 0 || (a && n > 0));
    std::fill_n(a, n, Real(0));
}

extern "C" void dSetValue(dReal* a, int n, dReal value)
{
    EPODE_USER(n == 0 || (a && n > 0));
    std::fill_n(a, n, value);
}

extern "C" dReal dDot(const dReal* a, const dReal* b, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(n == 0 || (a && b && n > 0), 0);
    return dot(a, b, n);
}

extern "C" void dMultiply0(dReal* A, const dReal* B, const dReal* C, int p, int q, int r)
{
    const FloatEnvironment floats;
    EPODE_USER(A && B && C && p > 0 && q > 0 && r > 0);
    multiply(A, B, C, p, q, r);
}

extern "C" void dMultiply1(dReal* A, const dReal* B, const dReal* C, int p, int q, int r)
{
    const FloatEnvironment floats;
    EPODE_USER(A && B && C && p > 0 && q > 0 && r > 0);
    multiply_transposed_left(A, B, C, p, q, r);
}

extern "C" void dMultiply2(dReal* A, const dReal* B, const dReal* C, int p, int q, int r)
{
    const FloatEnvironment floats;
    EPODE_USER(A && B && C && p > 0 && q > 0 && r > 0);
    multiply_transposed_right(A, B, C, p, q, r);
}

extern "C" int dFactorCholesky(dReal* A, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(A && n > 0, 0);
    return factor_cholesky(A, n);
}

extern "C" void dSolveCholesky(const dReal* L, dReal* b, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(L && b && n > 0);
    solve_cholesky(L, b, n);
}

extern "C" int dInvertPDMatrix(const dReal* A, dReal* Ainv, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(A && Ainv && n > 0, 0);
    Scratch L(padded_size(n, n));
    EPODE_USER_SAY(L.ok(), kOutOfMemory, 0);
    std::copy_n(A, padded_size(n, n), L.data());
    if (!factor_cholesky(L.data(), n)) return 0;
    invert_from_cholesky(L.data(), Ainv, n);
    return 1;
}

extern "C" int dIsPositiveDefinite(const dReal* A, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(A && n > 0, 0);
    Scratch L(padded_size(n, n));
    EPODE_USER_SAY(L.ok(), kOutOfMemory, 0);
    std::copy_n(A, padded_size(n, n), L.data());
    return factor_cholesky(L.data(), n);
}

extern "C" void dFactorLDLT(dReal* A, dReal* d, int n, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(n == 0 || (A && d && fits(n, nskip)));
    factor_ldlt(A, d, n, nskip);
}

extern "C" void dSolveL1(const dReal* L, dReal* b, int n, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(L && b && fits(n, nskip));
    solve_unit_lower(L, b, n, nskip);
}

extern "C" void dSolveL1T(const dReal* L, dReal* b, int n, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(L && b && fits(n, nskip));
    solve_unit_lower_transposed(L, b, n, nskip);
}

extern "C" void dScaleVector(dReal* a, const dReal* d, int n)
{
    const FloatEnvironment floats;
    EPODE_USER(n == 0 || (a && d && n > 0));
    for (int i = 0; i < n; ++i) a[i] *= d[i];
}

extern "C" void dVectorScale(dReal* a, const dReal* d, int n)
{
    EPODE_USER(n == 0 || (a && d && n > 0));
    dScaleVector(a, d, n);
}

extern "C" void dSolveLDLT(const dReal* L, const dReal* d, dReal* b, int n, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(L && d && b && fits(n, nskip));
    solve_ldlt(L, d, b, n, nskip);
}

extern "C" void dLDLTAddTL(dReal* L, dReal* d, const dReal* a, int n, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(L && d && a && n > 0 && nskip >= n);
    if (n < 2) return;
    Scratch work(3 * std::size_t(n));
    EPODE_USER_SAY(work.ok(), kOutOfMemory);
    add_to_top_left(L, d, a, n, nskip, work.data());
}

extern "C" void dLDLTRemove(dReal** A, const int* p, dReal* L, dReal* d, int n1, int n2, int r, int nskip)
{
    const FloatEnvironment floats;
    EPODE_USER(A && p && L && d && n1 > 0 && n2 > 0 && n2 <= n1 && r >= 0 && r < n2 && nskip >= n1);
    EPODE_USER(std::all_of(p, p + n2, [n1](int i) { return i >= 0 && i < n1; }));
    if (r == n2 - 1) return;
    Scratch work(2 * std::size_t(n2));
    EPODE_USER_SAY(work.ok(), kOutOfMemory);
    remove_from_ldlt(L, d, n2, r, nskip, work.data());
}

extern "C" void dRemoveRowCol(dReal* A, int n, int nskip, int r)
{
    EPODE_USER(A && n > 0 && nskip >= n && r >= 0 && r < n);
    remove_row_and_column(A, n, nskip, r);
}
