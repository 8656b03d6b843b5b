// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row-oriented (Cholesky-Banachiewicz): l_ij = (a_ij - <l_i, l_j>) / l_jj over the first j columns, so that
// every inner product reads two contiguous rows.
#include "math/cholesky.h"

#include <cmath>

namespace epode {

bool factor_cholesky(Real* A, int n)
{
    const int stride = padded(n);
    for (int i = 0; i < n; ++i) {
        Real* row = row_of(A, i, stride);
        for (int j = 0; j < i; ++j) {
            const Real* other = row_of(A, j, stride);
            row[j] = (row[j] - dot(row, other, j)) / other[j];
        }
        const Real pivot = row[i] - dot(row, row, i);
        if (!(pivot > 0)) return false;
        row[i] = std::sqrt(pivot);
    }
    return true;
}

void solve_cholesky(const Real* L, Real* b, int n)
{
    const int stride = padded(n);
    for (int i = 0; i < n; ++i) {
        const Real* row = row_of(L, i, stride);
        b[i] = (b[i] - dot(row, b, i)) / row[i];
    }
    for (int i = n; i-- > 0;) {
        const Real* row = row_of(L, i, stride);
        b[i] /= row[i];
        subtract_scaled(b, b[i], row, i);
    }
}

void invert_from_cholesky(const Real* L, Real* inverse, int n)
{
    const int stride = padded(n);
    for (int i = 0; i < n; ++i) {
        // Row i of the inverse solves L L^T x = e_i. The forward part starts at i, since y_k = 0 before;
        // the backward part may stop there, since the rest follows from symmetry.
        Real* x = row_of(inverse, i, stride);
        x[i] = 1 / row_of(L, i, stride)[i];
        for (int k = i + 1; k < n; ++k) {
            const Real* row = row_of(L, k, stride);
            x[k] = -dot(row + i, x + i, k - i) / row[k];
        }
        for (int k = n; k-- > i;) {
            const Real* row = row_of(L, k, stride);
            x[k] /= row[k];
            subtract_scaled(x + i, x[k], row + i, k - i);
        }
        for (int k = i + 1; k < n; ++k) row_of(inverse, k, stride)[i] = x[k];
        for (int k = n; k < stride; ++k) x[k] = 0;
    }
}

bool positive_definite(const Sym3& s)
{
    // Pivots of the LDL^T factorisation; written so that a NaN answers no.
    if (!(s.xx > 0)) return false;
    const Real l10 = s.xy / s.xx, l20 = s.xz / s.xx;
    const Real d1 = s.yy - l10 * s.xy;
    if (!(d1 > 0)) return false;
    const Real w21 = s.yz - l20 * s.xy;
    return s.zz - l20 * s.xz - w21 * w21 / d1 > 0;
}

bool invert_positive_definite(const Sym3& s, Sym3& inverse)
{
    if (!positive_definite(s)) return false;
    Real A[12] = {s.xx, 0, 0, 0, s.xy, s.yy, 0, 0, s.xz, s.yz, s.zz, 0};
    Real B[12];
    if (!factor_cholesky(A, 3)) return false;
    invert_from_cholesky(A, B, 3);
    inverse = {B[0], B[5], B[10], B[1], B[2], B[6]};
    return true;
}

}  // namespace epode
