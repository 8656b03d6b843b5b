// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Primal-dual active set: guess which rows lie on their bounds, solve the equalities of the others exactly,
// correct the guess. On resting and bilateral islands the guess is right after a few rounds, and the answer
// is then exact to rounding.
#pragma once

#include "solve/exact_problem.h"

namespace epode {

struct ActiveSetSettings {
    int rounds = 30;
    bool single_flips = false;  // when progress stops: flip one row at a time (Murty) instead of giving up
};

class ActiveSet {
  public:
    bool prepare(const ExactProblem& problem, Arena& arena);  // false: out of memory

    // True: exact. False: the rounds are used up; `state` is the best that is at hand.
    bool solve(ExactProblem& problem, BoxState& state, const ActiveSetSettings& settings, int& rounds);

  private:
    void settle(const ExactProblem& problem, BoxState& state);
    void refine(ExactProblem& problem, BoxState& state);
    int find_wrong(const ExactProblem& problem, const BoxState& state);

    std::span<double> D_, r_, r2_;
    std::span<int> wrong_;
};

}  // namespace epode
