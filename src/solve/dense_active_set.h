// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The active set on the dense dual matrix A = J M^-1 J^T + C, for islands of a few dozen rows: there is no
// structure to analyse, and a chain of n ball joints has 3n unknowns here instead of 6n.
#pragma once

#include "solve/active_set.h"
#include "solve/exact_problem.h"

namespace epode {

class DenseActiveSet {
  public:
    static constexpr int kMostRows = 64;

    // Forms A; false: out of memory.
    bool prepare(const ExactProblem& problem, std::span<const RowBlock> blocks, Arena& arena);

    // As ActiveSet::solve, but leaves state.v alone.
    bool solve(const ExactProblem& problem, BoxState& state, const ActiveSetSettings& settings, int& rounds);

  private:
    double* row(int i) { return A_.data() + std::size_t(i) * stride_; }
    double* factor_row(int i) { return L_.data() + std::size_t(i) * stride_; }
    void couple(const ExactProblem& problem, const RowBlock& x, const RowBlock& y);
    void gather_free(const BoxState& state);
    void factor(const ExactProblem& problem);
    void solve_free(BoxState& state);
    bool settled(const ExactProblem& problem, const BoxState& state);
    int find_wrong(const ExactProblem& problem, const BoxState& state);

    int m_ = 0, free_count_ = 0;
    std::size_t stride_ = 0;
    std::span<double> A_, L_, b_, r_, w_;  // A_ and L_: stride_ numbers a row
    std::span<double> response_;           // twelve numbers a row
    std::span<int> free_, wrong_;
    std::span<int> begin_, end_;  // the columns of A's row that may not be zero
    std::span<int> lead_;         // the first column of L's row that may not be zero, even
};

}  // namespace epode
