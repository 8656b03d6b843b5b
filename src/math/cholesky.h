// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Symmetric positive definite matrices: A = L L^T, rows of stride padded(n), of which only the lower
// triangle is read. No pivoting: a positive definite matrix needs none, and any other one is to be
// recognised. Golub & Van Loan, "Matrix Computations", 4.2.
#pragma once

#include "math/dense.h"
#include "math/mat.h"

namespace epode {

// Replaces the lower triangle of A by L. False, with A partly overwritten, if a pivot is not positive.
bool factor_cholesky(Real* A, int n);

// b := (L L^T)^-1 b
void solve_cholesky(const Real* L, Real* b, int n);

// The full, exactly symmetric inverse of L L^T, padding zero. `inverse` must not overlap L.
void invert_from_cholesky(const Real* L, Real* inverse, int n);

// The same functions for the 3 x 3 tensors of rigid bodies.
bool positive_definite(const Sym3& s);
bool invert_positive_definite(const Sym3& s, Sym3& inverse);  // false and untouched if it is not

}  // namespace epode
