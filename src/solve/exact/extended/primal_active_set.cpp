// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See primal_active_set.h. The error of a row is the velocity by which its sign is violated.
#include "solve/exact/extended/primal_active_set.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kFeasible = 1e-11;  // tolerance of a sign, of the scale
constexpr double kGood = 1e-10;      // residual that ends the work
constexpr int kFlipRounds = 20;
constexpr int kPatience = 3;  // rounds without fewer wrong rows

}  // namespace

bool PrimalActiveSet::prepare(const ExactProblem& problem, Arena& arena)
{
    const int m = problem.row_count(), n = problem.unknowns();
    for (std::span<double>* rows : {&low_, &from_, &from_low_, &best_.p, &best_.low})
        *rows = arena.take<double>(m);
    best_.v = arena.take<double>(n);
    best_.tag = arena.take<BoxState::Tag>(m);
    wrong_ = arena.take<int>(m);
    return !arena.failed() && equalities_.prepare(problem, arena);
}

double PrimalActiveSet::solve(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds)
{
    std::fill(low_.begin(), low_.end(), 0.0);
    best_residual_ = HUGE_VAL;
    equalities_.velocities(problem, state, low_, v);
    keep_better(problem, state, v);
    if (!flip_rounds(problem, state, v, rounds) && best_residual_ > kGood) {
        go_back(state, v);
        descend(problem, state, v, rounds);
    }
    go_back(state, v);
    return best_residual_;
}

bool PrimalActiveSet::flip_rounds(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds)
{
    int fewest = problem.row_count() + 1, patience = kPatience;
    for (int round = 0; round < kFlipRounds; ++round) {
        if (problem.gives_up()) return false;
        ++rounds;
        settle(state);
        equalities_.solve(problem, state, low_, v);
        keep_better(problem, state, v);
        const int wrong = find_wrong(problem, state, v);
        if (wrong == 0) return true;
        if (wrong < fewest)
            fewest = wrong, patience = kPatience;
        else if (patience-- <= 0)
            return false;
        for (int k = 0; k < wrong; ++k) state.flip(wrong_[std::size_t(k)]);
    }
    return false;
}

void PrimalActiveSet::descend(ExactProblem& problem, BoxState& state, std::span<double> v, int& rounds)
{
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const double inside = std::min(std::max(state.p[i], state.lo[i]), state.hi[i]);
        if (inside != state.p[i]) state.p[i] = inside, low_[i] = 0;
    }
    const int max_rounds = 20 + 2 * problem.row_count();
    for (int round = 0; round < max_rounds && best_residual_ > kGood; ++round) {
        if (problem.gives_up()) return;
        ++rounds;
        settle(state);
        std::copy(state.p.begin(), state.p.end(), from_.begin());
        std::copy(low_.begin(), low_.end(), from_low_.begin());
        equalities_.solve(problem, state, low_, v);
        if (stop_at_bound(problem, state)) continue;
        keep_better(problem, state, v);
        if (!release_worst(problem, state, v)) return;
    }
}

// Sets impulses of bound rows to their bounds.
void PrimalActiveSet::settle(BoxState& state)
{
    for (std::size_t i = 0; i < low_.size(); ++i) {
        if (state.tag[i] == BoxState::kFree) continue;
        state.p[i] = state.tag[i] == BoxState::kUpper ? state.hi[i] : state.lo[i];
        low_[i] = 0;
    }
}

// Moves back along the way from from_ to the first bound in it; false: there is none.
bool PrimalActiveSet::stop_at_bound(const ExactProblem& problem, BoxState& state)
{
    const double tolerance = kFeasible * problem.scale();
    double share = 1;
    std::size_t blocking = low_.size();
    BoxState::Tag side = BoxState::kFree;
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const double d = problem.row(int(i)).d;
        if (state.tag[i] != BoxState::kFree || !(d > 0)) continue;
        const bool below = (state.lo[i] - state.p[i]) * d > tolerance;
        if (!below && !((state.p[i] - state.hi[i]) * d > tolerance)) continue;
        const double bound = below ? state.lo[i] : state.hi[i];
        const double here = std::max(0.0, (bound - from_[i]) / (state.p[i] - from_[i]));
        if (here < share) share = here, blocking = i, side = below ? BoxState::kLower : BoxState::kUpper;
    }
    if (blocking == low_.size()) return false;
    for (std::size_t i = 0; i < low_.size(); ++i) {
        if (state.tag[i] != BoxState::kFree) continue;
        const double way = (state.p[i] - from_[i]) + (low_[i] - from_low_[i]);
        const DoubleDouble p = DoubleDouble{from_[i], from_low_[i]} + share * way;
        state.p[i] = p.hi;
        low_[i] = p.lo;
    }
    state.tag[blocking] = side;
    return true;
}

// Frees the bound row whose multiplier is most wrong; false: all are right.
bool PrimalActiveSet::release_worst(const ExactProblem& problem, BoxState& state, std::span<const double> v)
{
    const int wrong = find_wrong(problem, state, v);
    double worst = 0;
    int release = -1;
    for (int k = 0; k < wrong; ++k) {
        const int i = wrong_[std::size_t(k)];
        const ExactRow& row = problem.row(i);
        if (state.tag[std::size_t(i)] == BoxState::kFree) continue;
        const double w = ExactProblem::jv(row, v.data()) + row.C * state.p[std::size_t(i)] - row.c;
        if (w * w / row.d > worst) worst = w * w / row.d, release = i;
    }
    if (release < 0) return false;
    state.tag[std::size_t(release)] = BoxState::kFree;
    return true;
}

void PrimalActiveSet::keep_better(const ExactProblem& problem, const BoxState& state,
                                  std::span<const double> v)
{
    const double residual = problem.residual_at(state, v);
    if (!(residual < best_residual_)) return;
    best_residual_ = residual;
    std::copy(state.p.begin(), state.p.end(), best_.p.begin());
    std::copy(low_.begin(), low_.end(), best_.low.begin());
    std::copy(state.tag.begin(), state.tag.end(), best_.tag.begin());
    std::copy(v.begin(), v.end(), best_.v.begin());
}

void PrimalActiveSet::go_back(BoxState& state, std::span<double> v)
{
    if (!(best_residual_ < HUGE_VAL)) return;
    std::copy(best_.p.begin(), best_.p.end(), state.p.begin());
    std::copy(best_.low.begin(), best_.low.end(), low_.begin());
    std::copy(best_.tag.begin(), best_.tag.end(), state.tag.begin());
    std::copy(best_.v.begin(), best_.v.end(), v.begin());
}

int PrimalActiveSet::find_wrong(const ExactProblem& problem, const BoxState& state, std::span<const double> v)
{
    const double tolerance = kFeasible * problem.scale();
    int count = 0;
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        if (state.tag[i] == BoxState::kFixed || !(row.d > 0)) continue;
        const double slack = tolerance / row.d;
        const double w = ExactProblem::jv(row, v.data()) + row.C * state.p[i] - row.c;
        const bool wrong = state.tag[i] == BoxState::kFree
                               ? state.p[i] < state.lo[i] - slack || state.p[i] > state.hi[i] + slack
                           : state.tag[i] == BoxState::kLower ? w < -tolerance
                                                              : w > tolerance;
        if (wrong) wrong_[std::size_t(count++)] = int(i);
    }
    return count;
}

}  // namespace epode
