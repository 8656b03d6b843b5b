// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The exact solve of islands of one to three bodies with more rows than unknowns: a box on the ground, a
// small stack. The active set of active_set.h with H = 1 + J^T D J as one dense matrix of at most 18 rows:
// nothing is ordered, analysed or packed. It differs in two things.
//
// Guesses: a row begins on the side on which its own step q = p - w / d ends, w = J v + C p - c, from the
// impulses of the last step. For a single row this is the answer, and at rest it is that of the last step.
// Without a warm start it says which contacts separate and where friction slides.
//
// Flips: all wrong rows in the first two rounds, then the worst alone. Half of the rows of a box are
// redundant, and flipping all of them cycles: of 168 phases of one box that tumbles onto a plane 4 did not
// settle that way; now all do, in 2.4 rounds on average. Islands of two and three bodies with many wrong rows
// are given up early and go to principal pivoting, which costs less.
#pragma once

#include <type_traits>

#include "solve/exact/problem/exact_problem.h"
#include "solve/exact/small/small_island.h"

namespace epode {

class FewBodies {
  public:
    static constexpr std::size_t kMaxBodies = 3;

    // Both phases; kNotSolved: the guesses do not settle, or not to the residual `enough`.
    SmallResult solve(RowSystem& system, double enough, Arena& arena, SolveReport& report,
                      WorkMeter* work = nullptr);

  private:
    static constexpr int kMaxUnknowns = 6 * int(kMaxBodies), kLanes = kMaxUnknowns / 2;

    // Calls `work` with the lanes of a vector of unknowns as a constant.
    template <class Work>
    void by_bodies(Work work) const
    {
        if (n_ <= 6) return work(std::integral_constant<int, 3>{});
        if (n_ <= 12) return work(std::integral_constant<int, 6>{});
        work(std::integral_constant<int, 9>{});
    }
    bool prepare(const RowSystem& system, WorkMeter* work, Arena& arena);
    bool settle(int& rounds);
    bool has_shifted() const;
    template <int Lanes>
    void begin();
    template <class Velocities>
    void choose(const Velocities& v);
    void factor();
    void add_rows(int first, int last);
    bool refine();
    template <int Lanes>
    double improve();
    int correct(double share);

    ExactProblem problem_;
    BoxState state_;
    std::span<double> D_, w_, weight_, begun_, v_, base_;
    std::span<int> rows_, open_;  // rows that may move
    bool warm_ = false;
    int n_ = 0, round_ = 0, wrong_ = 0, factorisations_ = 0;
    DoubleLane H_[kMaxUnknowns][kLanes];  // upper half: D and L^T times D
    double inverse_[kMaxUnknowns];        // of D
};

}  // namespace epode
