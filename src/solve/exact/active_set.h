// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Primal-dual active set: guess which rows lie on their bounds, solve the equalities of the others exactly,
// correct the guess. On resting and bilateral islands the guess is right after a few rounds, and the answer
// is then exact to rounding.
#pragma once

#include "solve/exact/problem/packed_rows.h"

namespace epode {

struct ActiveSetSettings {
    int rounds = 30;
    bool persistent = false;  // continues where the guess looks hopeless, finally one row at a time (Murty)
};

class ActiveSet {
  public:
    bool prepare(const ExactProblem& problem, int places, Arena& arena);  // false: out of memory

    // From rows.p and the tags to the answer in rows.p, with its velocities `v`, 6 per body. True: exact.
    // False: the rounds are used up or do not help; the result may be far off.
    bool solve(ExactProblem& problem, PackedRows& rows, std::span<double> v,
               const ActiveSetSettings& settings, int& rounds);

  private:
    void settle(PackedRows& rows);
    void refine(ExactProblem& problem, PackedRows& rows, std::span<double> v);
    int find_wrong(const ExactProblem& problem, const PackedRows& rows, std::span<const double> v);
    void flip_apart(const ExactProblem& problem, PackedRows& rows, int wrong);
    void flip(PackedRows& rows, int place);

    std::span<double> D_, w_, scratch_;  // per place
    std::span<double> r_;                // per unknown
    std::span<int> wrong_;
    std::span<bool> touched_;  // per body
};

}  // namespace epode
