// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A = J J^T + C of the free rows, dense, as L D L^T in 106 bits: for islands of a few hundred rows whose
// redundant rows leave A with eigenvalues so small that neither a factor in doubles nor conjugate residuals
// with one can resolve them. Long lever arms cause that: d of a joint 1e6 m from its body is 1e12 times what
// C adds, and with C = 1e-9 the eigenvalues of redundant rows lie at 1e-21 d, below the rounding of doubles,
// above that of 106 bits.
//
// No pivoting: A is positive definite except for rounding. A pivot that is rounding belongs to a row that
// follows from those before it. Raised to the size of rounding it gives the row that much compliance, and
// refinement removes this as far as the rows agree.
#pragma once

#include "solve/exact/problem/exact_problem.h"

namespace epode {

class ExtendedFactor {
  public:
    static constexpr int kMaxRows = 512;
    // Microseconds of one core, of a factor of so many rows.
    static double work(int rows) { return 1e-3 * double(rows) * double(rows) * double(rows); }

    // False: out of memory. `rows`: as many as the problem has, at most kMaxRows.
    bool prepare(int rows, Arena& arena);

    // Rows for which `free` is positive, in the problem's order.
    void factor(const ExactProblem& problem, std::span<const double> free);
    // x = A^-1 x for free rows; the others are 0 before and after.
    void solve(std::span<DoubleDouble> x) const;

  private:
    std::span<DoubleDouble> row(int k) { return L_.subspan(start(k), std::size_t(k) + 1); }
    std::span<const DoubleDouble> row(int k) const { return L_.subspan(start(k), std::size_t(k) + 1); }
    static std::size_t start(int k) { return std::size_t(k) * (std::size_t(k) + 1) / 2; }
    void fill(const ExactProblem& problem);
    void eliminate(int k, double d);

    int count_ = 0;                   // free rows
    std::span<int> free_;             // which
    std::span<DoubleDouble> L_;       // lower half, row by row, with D on the diagonal
    std::span<DoubleDouble> column_;  // of L D
};

}  // namespace epode
