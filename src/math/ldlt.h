// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Symmetric matrices as A = L D L^T with unit lower triangular L, held in the strict lower triangle of an
// n x n array of any row stride >= n (the diagonal of the array is neither read nor written by the solves),
// and `d` holding the RECIPROCALS of D, because solving multiplies and never divides.
// No pivoting: meant for positive definite matrices; a zero pivot shows as an infinite reciprocal.
// Updates after Gill, Golub, Murray & Saunders, "Methods for modifying matrix factorizations", Math. Comp. 28
// (1974), method C1.
#pragma once

#include "math/dense.h"

namespace epode {

void factor_ldlt(Real* A, Real* d, int n, int stride);
// Its last part for one row: `row` has row i of L D and then that of L; d[i] is what their product leaves of a_ii.
void scale_ldlt_row(Real* row, Real* d, int i);

// b := L^-1 b, b := L^-T b, and b := A^-1 b.
void solve_unit_lower(const Real* L, Real* b, int n, int stride);
void solve_unit_lower_transposed(const Real* L, Real* b, int n, int stride);
void solve_ldlt(const Real* L, const Real* d, Real* b, int n, int stride);

// L, d := factors of L D L^T + alpha w w^T. w is used up; `work` holds n numbers.
void update_ldlt(Real* L, Real* d, int n, int stride, Real alpha, Real* w, Real* work);

// A grows by a[0] at (0,0) and by a[i] at (i,0) and (0,i). Rows and columns 1.. of L and d become the new
// factors; column 0 and d[0] keep their old values, since this serves a row that is about to be dropped.
// `work` holds 3 n numbers.
void add_to_top_left(Real* L, Real* d, const Real* a, int n, int stride, Real* work);

// The factors of A without its row and column r; `work` holds 2 n numbers.
void remove_from_ldlt(Real* L, Real* d, int n, int r, int stride, Real* work);

}  // namespace epode
