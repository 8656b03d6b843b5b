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

}  // namespace

bool ActiveSet::prepare(const ExactProblem& problem, Arena& arena)
{
    D_ = arena.take<double>(problem.row_count());
    r2_ = arena.take<double>(problem.row_count());
    wrong_ = arena.take<int>(problem.row_count());
    r_ = arena.take<double>(problem.unknowns());
    return !arena.failed();
}

bool ActiveSet::solve(ExactProblem& problem, BoxState& state, const ActiveSetSettings& settings, int& rounds)
{
    int fewest = problem.row_count() + 1, patience = kPatience;
    problem.velocities(state.p, state.v);
    for (int round = 0; round < settings.rounds; ++round) {
        ++rounds;
        settle(problem, state);
        problem.factor(D_);
        refine(problem, state);
        const int wrong = find_wrong(problem, state);
        if (wrong == 0) return true;
        const bool progress = wrong < fewest;
        if (progress) fewest = wrong, patience = kPatience;
        if (!progress && patience-- <= 0) {
            if (!settings.single_flips) return false;
            state.flip(wrong_[std::size_t(wrong) - 1]);
            continue;
        }
        for (int k = 0; k < wrong; ++k) state.flip(wrong_[std::size_t(k)]);
    }
    return false;
}

// Impulses on their bounds, weights for the others.
void ActiveSet::settle(const ExactProblem& problem, BoxState& state)
{
    for (std::size_t i = 0; i < state.p.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        D_[i] = 0;
        switch (state.tag[i]) {
            case BoxState::kFixed:
            case BoxState::kLower:
                state.p[i] = state.lo[i];
                break;
            case BoxState::kUpper:
                state.p[i] = state.hi[i];
                break;
            case BoxState::kFree:
                D_[i] = 1 / std::max(row.C, row.weight_min);
                break;
        }
    }
}

void ActiveSet::refine(ExactProblem& problem, BoxState& state)
{
    const double small = 1e-15 * problem.scale();
    double before = HUGE_VAL;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        problem.momentum_change(state.v, r_);
        for (std::size_t i = 0; i < state.p.size(); ++i) {
            const ExactRow& row = problem.row(int(i));
            double push = state.p[i];
            if (D_[i] > 0) {
                r2_[i] = row.c - ExactProblem::jv(row, state.v.data()) - row.C * state.p[i];
                push += D_[i] * r2_[i];
            }
            if (push != 0) ExactProblem::add_jt(row, push, r_.data());
        }
        problem.solve(r_);
        for (std::size_t i = 0; i < state.p.size(); ++i)
            if (D_[i] > 0) state.p[i] += D_[i] * (r2_[i] - ExactProblem::jv(problem.row(int(i)), r_.data()));
        double change = 0;
        for (std::size_t i = 0; i < state.v.size(); ++i) {
            state.v[i] += r_[i];
            change = std::max(change, std::fabs(r_[i]));
        }
        // Corrections shrink by about the same factor each time: stop when the next one would be below
        // rounding, or when they have stopped shrinking. The first pass mostly moves v, it proves nothing.
        if (pass > 0 && (change >= 0.5 * before || change * (change / before) <= small)) break;
        if (change == 0) break;
        before = change;
    }
}

int ActiveSet::find_wrong(const ExactProblem& problem, const BoxState& state)
{
    const double tolerance = kFeasible * problem.scale();
    int count = 0;
    for (std::size_t i = 0; i < state.p.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        bool wrong = false;
        if (state.tag[i] == BoxState::kFree) {
            const double slack = tolerance / row.d;
            wrong = state.p[i] < state.lo[i] - slack || state.p[i] > state.hi[i] + slack;
        } else if (state.tag[i] != BoxState::kFixed) {
            const double w = ExactProblem::jv(row, state.v.data()) + row.C * state.p[i] - row.c;
            wrong = state.tag[i] == BoxState::kLower ? w < -tolerance : w > tolerance;
        }
        if (wrong) wrong_[std::size_t(count++)] = int(i);
    }
    return count;
}

}  // namespace epode
