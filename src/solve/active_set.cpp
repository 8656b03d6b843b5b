// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free rows satisfy w = J v + C p - c = 0; with D = 1/C on them and 0 elsewhere, eliminating p gives H dv =
// r. p is carried as an unknown of its own through the KKT refinement and never recomputed as (c - J v)/C,
// which would cost eps/C of it (8 digits at ODE's CFM):
//
//   r1 = M (v* - v) + J^T p,  r2 = c - J v - C p   (free rows)
//   dv = H^-1 (r1 + J^T D r2),  dp = D (r2 - J dv)
//
// A softness below 1e-11 d is replaced by that in D only; refinement against the true C converges for
// consistent redundant rows and leaves inconsistent ones as soft as that.
// All wrong rows are flipped while their number falls (Portugal, Judice & Vicente 1994); when it has not
// fallen for a while, only the last of them (Murty's rule, finite for this positive definite problem).
#include "solve/active_set.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kFeasible = 1e-11;  // relative tolerance of a sign, in units of the problem's velocity scale
constexpr int kPatience = 5;         // rounds without progress before single flips
constexpr int kMostPasses = 8;       // of refinement
constexpr int kFew = 8;              // wrong rows that are never hopeless

// Of guesses that settle, half of the rows are never wrong, a quarter only once, and the number falls by more
// than 0.6 in two rounds: 188 problems of walls, piles and pyramids, of which 5 would have settled in spite
// of this (after 9 to 20 rounds) and 112 not. What does not settle is found out after 2 rounds instead of 15.
bool hopeless(int wrong, const int* before, int count, int round)
{
    if (wrong <= kFew) return false;
    return (round == 0 && 2 * wrong > count) || (round > 0 && 4 * wrong > count) ||
           (round > 1 && wrong > 0.6 * before[1]);
}

}  // namespace

bool ActiveSet::prepare(const ExactProblem& problem, int places, Arena& arena)
{
    D_ = arena.take<double>(places);
    w_ = arena.take<double>(places);
    push_ = arena.take<double>(places);
    wrong_ = arena.take<int>(places);
    row_D_ = arena.take<double>(problem.row_count());
    r_ = arena.take<double>(problem.unknowns());
    return !arena.failed();
}

bool ActiveSet::solve(ExactProblem& problem, PackedRows& rows, std::span<double> v,
                      const ActiveSetSettings& settings, int& rounds)
{
    int fewest = rows.count() + 1, patience = kPatience;
    int before[2] = {};  // wrong rows one and two rounds ago
    std::fill(row_D_.begin(), row_D_.end(), 0.0);
    rows.velocities(problem, r_, v);
    for (int round = 0; round < settings.rounds; ++round) {
        ++rounds;
        settle(rows);
        rows.spread(D_, row_D_);
        problem.factor(row_D_);
        refine(problem, rows, v);
        const int wrong = find_wrong(problem, rows, v);
        if (wrong == 0) return true;
        if (!settings.single_flips && hopeless(wrong, before, rows.count(), round)) return false;
        before[1] = before[0], before[0] = wrong;
        const bool progress = wrong < fewest;
        if (progress) fewest = wrong, patience = kPatience;
        if (!progress && patience-- <= 0) {
            if (!settings.single_flips) return false;
            flip(rows, wrong_[std::size_t(wrong) - 1]);
            continue;
        }
        for (int k = 0; k < wrong; ++k) flip(rows, wrong_[std::size_t(k)]);
    }
    return false;
}

// Impulses on their bounds, weights for the others.
void ActiveSet::settle(PackedRows& rows)
{
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i) {
        D_[i] = 0;
        switch (rows.tag[i]) {
            case BoxState::kFixed:
                break;
            case BoxState::kLower:
                rows.p[i] = rows.lo[i];
                break;
            case BoxState::kUpper:
                rows.p[i] = rows.hi[i];
                break;
            case BoxState::kFree:
                D_[i] = 1 / std::max(rows.C[i], rows.weight_min[i]);
                break;
        }
    }
}

void ActiveSet::refine(ExactProblem& problem, PackedRows& rows, std::span<double> v)
{
    const double small = 1e-15 * problem.scale();
    const auto n = std::size_t(rows.count());
    const std::span<double> w = w_.first(n), push = push_.first(n);
    double before = HUGE_VAL;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        rows.momentum_change(problem, v, r_);
        rows.products(v, w);
        for (std::size_t i = 0; i < n; ++i) {
            w[i] = rows.c[i] - w[i] - rows.C[i] * rows.p[i];
            push[i] = rows.p[i] + D_[i] * w[i];
        }
        rows.add_transposed(push, r_);
        problem.solve(r_);
        rows.products(r_, push);
        for (std::size_t i = 0; i < n; ++i) rows.p[i] += D_[i] * (w[i] - push[i]);
        double change = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            v[i] += r_[i];
            change = std::max(change, std::fabs(r_[i]));
        }
        // Corrections shrink by about the same factor each time: stop when the next one would be below
        // rounding, or when they have stopped shrinking. The first pass mostly moves v, it proves nothing.
        if (pass > 0 && (change >= 0.5 * before || change * (change / before) <= small)) break;
        if (change == 0) break;
        before = change;
    }
}

int ActiveSet::find_wrong(const ExactProblem& problem, const PackedRows& rows, std::span<const double> v)
{
    const double tolerance = kFeasible * problem.scale();
    rows.products(v, w_);
    int count = 0;
    for (std::size_t i = 0; i < std::size_t(rows.count()); ++i) {
        bool wrong = false;
        if (rows.tag[i] == BoxState::kFree) {
            const double slack = tolerance * rows.inv_d[i];
            wrong = rows.p[i] < rows.lo[i] - slack || rows.p[i] > rows.hi[i] + slack;
        } else if (rows.tag[i] != BoxState::kFixed) {
            const double w = w_[i] + rows.C[i] * rows.p[i] - rows.c[i];
            wrong = rows.tag[i] == BoxState::kLower ? w < -tolerance : w > tolerance;
        }
        if (wrong) wrong_[std::size_t(count++)] = int(i);
    }
    return count;
}

// The other side of a wrong guess.
void ActiveSet::flip(PackedRows& rows, int place)
{
    const auto i = std::size_t(place);
    BoxState::Tag& tag = rows.tag[i];
    tag = tag != BoxState::kFree   ? BoxState::kFree
          : rows.p[i] < rows.lo[i] ? BoxState::kLower
                                   : BoxState::kUpper;
}

}  // namespace epode
