// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Solves the equalities of given free rows where double precision is too narrow. One gram between two tons
// has impulses whose rounding alone, eps d |p|, moves it by more than the promised 1e-9; loops with redundant
// joints and a CFM of 1e-10 have A = J J^T + C with eigenvalues of 1e-13 d, which no factor in doubles
// resolves. Here impulses are p = hi + lo and J^T p is summed in 106 bits, and
//
//   A p = b:   v = v* + J^T p,  r = c - J v - C p = 0
//
// is solved by conjugate residuals that keep all directions (GCR: Eisenstat, Elman & Schultz, SIAM J. Numer.
// Anal. 20, 1983), with the approximate inverse B = (A + F)^-1, F = 1e-11 d. One solution with H = 1 + J^T D
// J gives B (Woodbury), D = 1/(C + F): H x = J^T D r, z = D (r - J x). In the inner product with weights 1/d,
// F is a multiple of 1, so A B is symmetric with eigenvalues a/(a + F): one cluster at 1, and one more pass
// for each redundant row. Refinement with B alone would need F/C passes. What these passes leave of a small
// island is refined with a dense factor in 106 bits (solve/exact/extended/extended_factor.h).
#pragma once

#include "solve/exact/extended/extended_factor.h"

namespace epode {

class ExtendedRefinement {
  public:
    // False: out of memory. The factor of H must have been built.
    bool prepare(const ExactProblem& problem, Arena& arena);
    // From now on with the dense factor; false: out of memory.
    bool prepare_dense(int rows, Arena& arena);

    // Impulses of rows that are not free are data. `low`, which is added to p, persists from call to call;
    // the velocities that belong to the impulses are left in `v`.
    void solve(ExactProblem& problem, BoxState& state, std::span<double> low, std::span<double> v);

    // v of the present impulses, with all their digits.
    void velocities(const ExactProblem& problem, const BoxState& state, std::span<const double> low,
                    std::span<double> v)
    {
        problem.velocities(state.p, low, sums_, v);
    }

  private:
    std::span<double> direction(int k) { return pairs_.subspan(2 * std::size_t(k) * r_.size(), r_.size()); }
    std::span<double> image(int k) { return pairs_.subspan((2 * std::size_t(k) + 1) * r_.size(), r_.size()); }
    void iterate(ExactProblem& problem, BoxState& state, std::span<double> low, std::span<double> v);
    void refine(const ExactProblem& problem, BoxState& state, std::span<double> low);
    double largest_defect(const ExactProblem& problem, const BoxState& state, std::span<const double> low);
    void weigh(const ExactProblem& problem, const BoxState& state);
    double residual(const ExactProblem& problem, const BoxState& state, std::span<const double> low,
                    std::span<double> v);
    void precondition(ExactProblem& problem, std::span<double> z);
    bool orthogonalise(const ExactProblem& problem, int k);
    void take_image(const ExactProblem& problem, int k);
    void advance(BoxState& state, std::span<double> low, int j);
    double dot(std::span<const double> x, std::span<const double> y) const;

    int directions_ = 0;
    bool dense_ = false;
    std::span<double> D_, inv_d_, r_, pairs_, x_;
    std::span<DoubleDouble> sums_, defects_;
    ExtendedFactor factor_;
};

}  // namespace epode
