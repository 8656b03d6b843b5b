// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An interior-point method for the same box problem: slower than a good guess of the active set, but it
// passes through the interior and needs no guess. The number of iterations hardly depends on the size of the
// problem.
#pragma once

#include "solve/exact/problem/packed_rows.h"

namespace epode {

class InteriorPoint {
  public:
    bool prepare(const ExactProblem& problem, int places, Arena& arena);  // false: out of memory

    // Starts from rows.p; afterwards p is on its bounds where it belongs and the tags say so. `v`: 6 per
    // body, the velocities of the last iterate. True if the tolerance (relative to the problem's scale) was
    // reached.
    bool solve(ExactProblem& problem, PackedRows& rows, std::span<double> v, double tolerance,
               int& iterations);

  private:
    void lay_out();
    void move_inside(std::size_t i, double scale);
    void start(const ExactProblem& problem, std::span<double> v);
    template <typename AddTarget>
    void direction(ExactProblem& problem, const AddTarget& add_target);
    double complementarity(double step) const;
    double longest_step() const;
    double aim(ExactProblem& problem);
    double recentre(ExactProblem& problem);
    void correct_centrality(ExactProblem& problem, double target);
    void tag();

    PackedRows* packed_ = nullptr;
    InteriorRows rows_;
    RowKernels::Residuals now_{};
    RowKernels::Direction ahead_{};
    int bounds_ = 0;             // number of finite bounds
    std::span<double> numbers_;  // all arrays of rows_
    std::span<double> r1_, dv_;
    std::span<double> kept_dp_, kept_dv_;  // before a corrector
    std::size_t places_ = 0;
};

}  // namespace epode
