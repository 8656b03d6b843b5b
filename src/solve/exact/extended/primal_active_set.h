// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The fallback of the exact solver, for the few islands whose residual the fast methods leave above the
// promise: an active set whose equalities are solved with 106 bits
// (solve/exact/extended/extended_refinement.h), in two stages.
//
//   1. flips, as in active_set.cpp: usually only digits were missing;
//   2. from the best point so far the primal active-set method for strictly convex quadratic programs
//      (Nocedal & Wright, Numerical Optimization, 16.5): move towards the solution of the free rows, stop at
//      the first bound and keep it; if none is in the way, release the bound whose multiplier is most wrong.
//      The energy 1/2 p A p - b p falls in every round, so no set of bounds comes twice. Murty's rule is
//      finite too, but has no bound on its time.
#pragma once

#include "solve/exact/extended/extended_refinement.h"

namespace epode {

class PrimalActiveSet {
  public:
    bool prepare(const ExactProblem& problem, Arena& arena);  // false: out of memory
    // For islands that still lack digits: solves the equalities densely from now on. False: out of memory.
    bool prepare_dense(const ExactProblem& problem, Arena& arena)
    {
        return equalities_.prepare_dense(problem.row_count(), arena);
    }

    // The factor of H must have been built. Leaves the best point found in `state`, with the velocities that
    // belong to its impulses with all their digits in `v`, and returns its residual.
    double solve(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds);

  private:
    struct Point {
        std::span<double> p, low, v;
        std::span<BoxState::Tag> tag;
    };

    bool flip_rounds(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds);
    void descend(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds);
    void settle(BoxState& state);
    bool stop_at_bound(const ExactProblem& problem, BoxState& state);
    bool release_worst(const ExactProblem& problem, BoxState& state, std::span<const double> v);
    void keep_better(const ExactProblem& problem, const BoxState& state, std::span<const double> v);
    void go_back(BoxState& state, std::span<double> v);
    int find_wrong(const ExactProblem& problem, const BoxState& state, std::span<const double> v);

    ExtendedRefinement equalities_;
    Point best_;
    double best_residual_ = 0;
    std::span<double> low_, from_, from_low_;
    std::span<int> wrong_;
};

}  // namespace epode
