// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Interior point for the same box problem: slower than a good guess of the active set, but it walks through
// the middle and needs no guess. The number of iterations hardly depends on the problem's size.
#pragma once

#include "solve/exact_problem.h"

namespace epode {

class InteriorPoint {
  public:
    bool prepare(const ExactProblem& problem, Arena& arena);  // false: out of memory

    // From state.p; afterwards p is on its bounds where it belongs and the tags say so. True when the
    // tolerance (relative to the problem's scale) was reached.
    bool solve(ExactProblem& problem, BoxState& state, double tolerance, int& iterations);

  private:
    // One side of one row: slack and multiplier, and their directions. `z` is 0 where there is no bound.
    struct Side {
        double s, z, ds, dz, r, t, kept;
        bool present;
    };
    struct RowState {
        Side lower, upper;
        double r2, e, dp;
    };

    void start(const ExactProblem& problem, BoxState& state);
    double residuals(const ExactProblem& problem, const BoxState& state);  // returns the stop measure
    double complementarity(const ExactProblem& problem, double step) const;
    void factor(ExactProblem& problem, const BoxState& state);
    void direction(ExactProblem& problem, const BoxState& state);
    double aim(ExactProblem& problem, const BoxState& state);
    double recentre(ExactProblem& problem, const BoxState& state);
    void correct_centrality(ExactProblem& problem, const BoxState& state, double target);
    double longest_step() const;
    void advance(BoxState& state, double step);
    void tag(const ExactProblem& problem, BoxState& state) const;

    std::span<RowState> rows_;
    std::span<double> D_, r1_, dv_;
};

}  // namespace epode
