// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One factorisation of H = M + J^T D J, D = 1/C, and as few passes of the KKT refinement of active_set.cpp as
// suffice:
//
//   r1 = M (v* - v) + J^T p,  r2 = c - J v - C p,  dv = H^-1 (r1 + J^T D r2),  dp = D (r2 - J dv)
//
// The first pass leaves a residual of the order of the factor's rounding times D, a hundredth to a millionth.
#include "solve/exact/equalities.h"

#include <algorithm>
#include <cmath>

#include "solve/exact/problem/exact_problem.h"

namespace epode {
namespace {

constexpr int kEqualityPasses = 4;
constexpr double kEnough = 1e-4;  // of the largest velocity change of a row

class Equalities {
  public:
    bool prepare(const RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena)
    {
        if (!problem_.build(system, nullptr, arena) ||
            !problem_.build_factor(system, symbolic_cache, Tasks(1), arena))
            return false;
        const int m = problem_.row_count();
        D_ = arena.take<double>(m);
        p_ = arena.take_zeroed<double>(m);
        r2_ = arena.take<double>(m);
        v_ = arena.take<double>(problem_.unknowns());
        r_ = arena.take<double>(problem_.unknowns());
        return !arena.failed();
    }

    void solve()
    {
        for (std::size_t i = 0; i < D_.size(); ++i) {
            const ExactRow& row = problem_.row(int(i));
            D_[i] = row.d > 0 ? 1 / std::max(row.C, row.weight_min) : 0;
        }
        problem_.factor(D_);
        problem_.velocities(p_, v_);
        const double enough = kEnough * measure();
        for (int pass = 0; pass < kEqualityPasses; ++pass) {
            correct();
            if (measure() <= enough) return;
        }
    }

    void store(RowSystem& system) { problem_.store(system, p_, v_); }

  private:
    // Computes r2; returns its largest element.
    double measure()
    {
        double worst = 0;
        for (std::size_t i = 0; i < D_.size(); ++i) {
            const ExactRow& row = problem_.row(int(i));
            r2_[i] = row.c - ExactProblem::jv(row, v_.data()) - row.C * p_[i];
            worst = std::max(worst, std::fabs(r2_[i]));
        }
        return worst;
    }

    void correct()
    {
        problem_.momentum_change(v_, r_);
        for (std::size_t i = 0; i < D_.size(); ++i)
            ExactProblem::add_jt(problem_.row(int(i)), p_[i] + D_[i] * r2_[i], r_.data());
        problem_.solve(r_);
        for (std::size_t i = 0; i < D_.size(); ++i)
            p_[i] += D_[i] * (r2_[i] - ExactProblem::jv(problem_.row(int(i)), r_.data()));
        for (std::size_t i = 0; i < v_.size(); ++i) v_[i] += r_[i];
    }

    ExactProblem problem_;
    std::span<double> D_, p_, r2_, v_, r_;
};

}  // namespace

bool solve_equalities(RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena)
{
    Arena::Scope scope(arena);
    Equalities equalities;
    if (!equalities.prepare(system, symbolic_cache, arena)) return false;
    equalities.solve();
    equalities.store(system);
    return true;
}

}  // namespace epode
