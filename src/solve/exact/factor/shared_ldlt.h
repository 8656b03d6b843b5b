// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The dense L D L^T of math/ldlt shared among workers, element by element with the same sums in the same
// order: the bits are those of one thread. Pieces wait for what they need of each other while both run (a
// wavefront): rows of L become known one after another, and every later row uses each at once. The usual
// alternative, blocks with a barrier after each panel, changes the order of sums and stops at every barrier.
#pragma once

#include "math/dense.h"
#include "tasks/tasks.h"

namespace epode {

void factor_ldlt(Real* A, Real* d, int n, int stride, const Tasks& tasks);
void solve_unit_lower(const Real* L, Real* b, int n, int stride, const Tasks& tasks);
void solve_unit_lower_transposed(const Real* L, Real* b, int n, int stride, const Tasks& tasks);
void solve_ldlt(const Real* L, const Real* d, Real* b, int n, int stride, const Tasks& tasks);
void scale_vector(Real* a, const Real* d, int n, const Tasks& tasks);

}  // namespace epode
