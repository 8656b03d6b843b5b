// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Residuals are recomputed from p in every pass and images from their directions, and every pass minimises
// the residual along all of them: rounding and errors of the factor only cost passes.
#include "solve/exact/extended/extended_refinement.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kEnough = 1e-13;       // of the scale: nothing left to correct
constexpr double kDenseEnough = 1e-20;  // the same in 106 bits
constexpr int kMaxPasses = 80;
constexpr int kDensePasses = 6;
constexpr int kMaxDirections = 30;
constexpr int kMinDirections = 8;
constexpr double kDirectionPass = 0.005;  // microseconds of a row and a direction
constexpr int kManyRows = 2000;           // above this, directions cost too much memory

}  // namespace

bool ExtendedRefinement::prepare(const ExactProblem& problem, Arena& arena)
{
    const int m = problem.row_count(), n = problem.unknowns();
    for (std::span<double>* rows : {&D_, &inv_d_, &r_}) *rows = arena.take<double>(m);
    directions_ = m < kManyRows ? kMaxDirections : kMinDirections;
    pairs_ = arena.take<double>(2 * directions_ * m);
    x_ = arena.take<double>(n);
    sums_ = arena.take<DoubleDouble>(n);
    return !arena.failed();
}

bool ExtendedRefinement::prepare_dense(int rows, Arena& arena)
{
    defects_ = arena.take<DoubleDouble>(rows);
    dense_ = factor_.prepare(rows, arena);
    return dense_;
}

void ExtendedRefinement::solve(ExactProblem& problem, BoxState& state, std::span<double> low,
                               std::span<double> v)
{
    weigh(problem, state);
    if (!dense_) return iterate(problem, state, low, v);
    refine(problem, state, low);
    velocities(problem, state, low, v);
}

void ExtendedRefinement::iterate(ExactProblem& problem, BoxState& state, std::span<double> low,
                                 std::span<double> v)
{
    problem.factor(D_);
    double mark = HUGE_VAL, now = residual(problem, state, low, v);
    for (int pass = 0, stall = 0, k = 0; pass < kMaxPasses && now > kEnough * problem.scale(); ++pass) {
        if (k == directions_) k = 0;
        if (problem.gives_up()) return;
        problem.count_work(kDirectionPass * double(D_.size()) * (k + 4));
        precondition(problem, direction(k));
        if (!orthogonalise(problem, k)) return;
        ++k;
        for (int j = 0; j < k; ++j) advance(state, low, j);
        now = residual(problem, state, low, v);
        stall = now < 0.5 * mark ? 0 : stall + 1;
        if (stall == 0) mark = now;
        if (stall > directions_) return;
    }
}

void ExtendedRefinement::refine(const ExactProblem& problem, BoxState& state, std::span<double> low)
{
    factor_.factor(problem, D_);
    double before = HUGE_VAL, now = largest_defect(problem, state, low);
    for (int pass = 0; pass < kDensePasses && now > kDenseEnough * problem.scale(); ++pass) {
        if (!(now < 0.5 * before)) return;
        factor_.solve(defects_);
        for (std::size_t i = 0; i < D_.size(); ++i) {
            if (!(D_[i] > 0)) continue;
            const DoubleDouble p = DoubleDouble{state.p[i], low[i]} + defects_[i];
            state.p[i] = p.hi;
            low[i] = p.lo;
        }
        before = now;
        now = largest_defect(problem, state, low);
    }
}

// Leaves r in defects_.
double ExtendedRefinement::largest_defect(const ExactProblem& problem, const BoxState& state,
                                          std::span<const double> low)
{
    problem.defect(state.p, low, D_, sums_, defects_);
    double worst = 0;
    for (const DoubleDouble& x : defects_) worst = std::max(worst, std::fabs(x.hi));
    return worst;
}

void ExtendedRefinement::weigh(const ExactProblem& problem, const BoxState& state)
{
    for (std::size_t i = 0; i < D_.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        inv_d_[i] = row.d > 0 ? 1 / row.d : 0;
        const bool free = state.tag[i] == BoxState::kFree && row.d > 0;
        D_[i] = free ? 1 / (row.C + row.weight_min) : 0;
    }
}

// v and r of the present impulses; returns max |r|.
double ExtendedRefinement::residual(const ExactProblem& problem, const BoxState& state,
                                    std::span<const double> low, std::span<double> v)
{
    velocities(problem, state, low, v);
    double worst = 0;
    for (std::size_t i = 0; i < r_.size(); ++i) {
        const ExactRow& row = problem.row(int(i));
        r_[i] = D_[i] > 0 ? row.c - ExactProblem::jv(row, v.data()) - row.C * state.p[i] : 0;
        worst = std::max(worst, std::fabs(r_[i]));
    }
    return worst;
}

// z = B r
void ExtendedRefinement::precondition(ExactProblem& problem, std::span<double> z)
{
    std::fill(x_.begin(), x_.end(), 0.0);
    for (std::size_t i = 0; i < D_.size(); ++i)
        if (D_[i] > 0) ExactProblem::add_jt(problem.row(int(i)), D_[i] * r_[i], x_.data());
    problem.solve(x_);
    for (std::size_t i = 0; i < D_.size(); ++i)
        z[i] = D_[i] > 0 ? D_[i] * (r_[i] - ExactProblem::jv(problem.row(int(i)), x_.data())) : 0;
}

// Makes the image of direction k orthogonal to the earlier ones and of length 1.
bool ExtendedRefinement::orthogonalise(const ExactProblem& problem, int k)
{
    const std::span<double> q = direction(k), Aq = image(k);
    take_image(problem, k);
    for (int j = 0; j < k; ++j) {
        const double along = dot(Aq, image(j)) / dot(image(j), image(j));
        for (std::size_t i = 0; i < q.size(); ++i) {
            q[i] -= along * direction(j)[i];
            Aq[i] -= along * image(j)[i];
        }
    }
    const double length = std::sqrt(dot(Aq, Aq));
    if (!(length > 0) || !(length < HUGE_VAL)) return false;
    for (double& x : q) x /= length;
    take_image(problem, k);
    return dot(Aq, Aq) > 0;
}

void ExtendedRefinement::take_image(const ExactProblem& problem, int k)
{
    const std::span<double> Aq = image(k);
    problem.apply(direction(k), sums_, x_, Aq);
    for (std::size_t i = 0; i < Aq.size(); ++i)
        if (!(D_[i] > 0)) Aq[i] = 0;
}

// Moves along direction j to the least residual.
void ExtendedRefinement::advance(BoxState& state, std::span<double> low, int j)
{
    const double step = dot(r_, image(j)) / dot(image(j), image(j));
    for (std::size_t i = 0; i < r_.size(); ++i) {
        const DoubleDouble p = DoubleDouble{state.p[i], low[i]} + step * direction(j)[i];
        state.p[i] = p.hi;
        low[i] = p.lo;
        r_[i] -= step * image(j)[i];
    }
}

double ExtendedRefinement::dot(std::span<const double> x, std::span<const double> y) const
{
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i] * inv_d_[i];
    return sum;
}

}  // namespace epode
