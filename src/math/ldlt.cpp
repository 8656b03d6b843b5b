// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Everything walks rows. Removing row r from L D L^T leaves the rows above it alone; below it, with l the
// part of column r under the diagonal, the trailing block becomes L3 D3 L3^T + D_r l l^T, which is an update
// with a positive weight and therefore stable. (ODE's interface also offers the original matrix for this;
// it is not needed.)
#include "math/ldlt.h"

#include <cstring>

namespace epode {

void factor_ldlt(Real* A, Real* d, int n, int stride)
{
    for (int i = 0; i < n; ++i) {
        // Row i of L D by forward substitution, then of L.
        Real* row = row_of(A, i, stride);
        solve_unit_lower(A, row, i, stride);
        scale_ldlt_row(row, d, i);
    }
}

void scale_ldlt_row(Real* row, Real* d, int i)
{
    Real pivot = row[i];
    for (int j = 0; j < i; ++j) {
        const Real scaled = row[j] * d[j];
        pivot -= row[j] * scaled;
        row[j] = scaled;
    }
    d[i] = 1 / pivot;
}

void solve_unit_lower(const Real* L, Real* b, int n, int stride)
{
    for (int i = 1; i < n; ++i) b[i] -= dot(row_of(L, i, stride), b, i);
}

void solve_unit_lower_transposed(const Real* L, Real* b, int n, int stride)
{
    for (int i = n - 1; i > 0; --i) subtract_scaled(b, b[i], row_of(L, i, stride), i);
}

void solve_ldlt(const Real* L, const Real* d, Real* b, int n, int stride)
{
    solve_unit_lower(L, b, n, stride);
    for (int i = 0; i < n; ++i) b[i] *= d[i];
    solve_unit_lower_transposed(L, b, n, stride);
}

void update_ldlt(Real* L, Real* d, int n, int stride, Real alpha, Real* w, Real* work)
{
    for (int i = 0; i < n; ++i) {
        // w_i after the elimination of the columns before it; work_j = alpha_j w_j / D'_j.
        Real* row = row_of(L, i, stride);
        Real wi = w[i];
        for (int j = 0; j < i; ++j) {
            wi -= w[j] * row[j];
            row[j] += work[j] * wi;
        }
        w[i] = wi;
        const Real D = 1 / d[i];
        d[i] = 1 / (D + alpha * wi * wi);
        work[i] = alpha * wi * d[i];
        alpha *= D * d[i];
    }
}

void add_to_top_left(Real* L, Real* d, const Real* a, int n, int stride, Real* work)
{
    // With D0, l = column 0 of L, u = D0 l + a: the block behind the first column gains D0 l l^T (the old
    // first column is put back) and loses u u^T / (D0 + a0) (the new one is taken out).
    const Real D0 = 1 / d[0];
    Real* l = work;
    Real* u = work + n;
    for (int i = 1; i < n; ++i) {
        l[i - 1] = row_of(L, i, stride)[0];
        u[i - 1] = D0 * l[i - 1] + a[i];
    }
    Real* block = L + stride + 1;
    update_ldlt(block, d + 1, n - 1, stride, D0, l, work + 2 * n);
    update_ldlt(block, d + 1, n - 1, stride, -1 / (D0 + a[0]), u, work + 2 * n);
}

void remove_from_ldlt(Real* L, Real* d, int n, int r, int stride, Real* work)
{
    const int below = n - 1 - r;
    if (below > 0) {
        for (int i = 0; i < below; ++i) work[i] = row_of(L, r + 1 + i, stride)[r];
        Real* block = row_of(L, r + 1, stride) + r + 1;
        update_ldlt(block, d + r + 1, below, stride, 1 / d[r], work, work + n);
        std::memmove(d + r, d + r + 1, sizeof(Real) * std::size_t(below));
    }
    remove_row_and_column(L, n, stride, r);
}

}  // namespace epode
