// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Corrections of a solution in which the rows that act move as they do, and the rows that yield with it.
#include "solve/tree/tree_solve.h"

#include <algorithm>
#include <cmath>

namespace epode {

// The factor of A for the rows that act.
bool TreeSolve::prepare_corrections(Arena& arena)
{
    acting_count_ = 0;
    for (int i = 0; i < int(rows_.size()); ++i)
        if (problem_.acts(i)) acting_[std::size_t(acting_count_++)] = i;
    const int n = acting_count_;
    const int all = int(u_.size()) + n;
    acting_factor_ = DenseFactor(arena.take<double>(n * n), n);
    excess_ = arena.take_zeroed<double>(int(rows_.size()));
    corrected_ = arena.take_zeroed<double>(int(u_.size()));
    correction_ = arena.take<double>(all), step_ = arena.take<double>(all), history_ = 0;
    for (int i = 0; i < kHistory; ++i)
        steps_[i] = arena.take<double>(all), changes_[i] = arena.take<double>(all);
    if (arena.failed()) return false;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k <= i; ++k)
            acting_factor_.row(i)[k] = problem_.row(acting_[std::size_t(i)])[acting_[std::size_t(k)]];
    return acting_factor_.factor();
}

// To correction_: z, then dp of the rows that act.
void TreeSolve::find_correction(std::span<double> r)
{
    const int n = acting_count_;
    const std::span<double> dp = correction_.subspan(r.size());
    factor_.to_factor_space(r);
    for (std::size_t k = 0; k < r.size(); ++k) r[k] += corrected_[k];
    for (int i = 0; i < n; ++i) {
        const int row = acting_[std::size_t(i)];
        dp[std::size_t(i)] = excess_[std::size_t(row)] - product(y(row), r.data(), r.size());
    }
    acting_factor_.solve(dp);
    for (int i = 0; i < n; ++i) {
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < r.size(); ++k) r[k] += dp[std::size_t(i)] * its[k];
    }
    std::copy(r.begin(), r.end(), correction_.begin());
}

// Anderson's: with f the correction and x what is corrected, the step f - sum g (dx + df) with the g that make f - sum g df least, in z,
// the metric of energy.
void TreeSolve::extrapolate()
{
    const std::size_t n = u_.size(), all = correction_.size();
    std::copy(correction_.begin(), correction_.end(), step_.begin());
    if (history_ == 0) return;
    const auto of_z = [&](std::span<const double> a, std::span<const double> b) {
        return product(a.data(), b.data(), n);
    };
    const std::span<double> a = changes_[0], b = changes_[1];
    double g = 0, k = 0;
    const double aa = of_z(a, a), af = of_z(a, correction_);
    if (history_ == 1) {
        if (aa > 0) g = af / aa;
    } else {
        const double bb = of_z(b, b), ab = of_z(a, b), bf = of_z(b, correction_), det = aa * bb - ab * ab;
        constexpr double kIndependent = 1e-8;
        if (det > kIndependent * aa * bb)
            g = (af * bb - bf * ab) / det, k = (bf * aa - af * ab) / det;
        else if (aa > 0)
            g = af / aa;
    }
    for (std::size_t i = 0; i < all; ++i) step_[i] -= g * (steps_[0][i] + a[i]);
    if (k != 0)
        for (std::size_t i = 0; i < all; ++i) step_[i] -= k * (steps_[1][i] + b[i]);
}

double TreeSolve::correct(std::span<double> r)
{
    const std::size_t n = r.size();
    // changes_[0] still holds the last correction; it becomes the change since then.
    find_correction(r);
    if (history_ > 0)
        for (std::size_t i = 0; i < correction_.size(); ++i) changes_[0][i] = correction_[i] - changes_[0][i];
    extrapolate();
    std::swap(steps_[0], steps_[1]), std::swap(changes_[0], changes_[1]);
    std::copy(step_.begin(), step_.end(), steps_[0].begin());
    std::copy(correction_.begin(), correction_.end(), changes_[0].begin());
    history_ = std::min(history_ + 1, kHistory);
    for (int i = 0; i < acting_count_; ++i) {
        const TreeRow& row = rows_[std::size_t(acting_[std::size_t(i)])];
        const double dp = step_[n + std::size_t(i)];
        const double* const its = y(acting_[std::size_t(i)]);
        for (std::size_t k = 0; k < n; ++k) corrected_[k] += dp * its[k];
        system_->numbers[std::size_t(row.source)].p += Real(row.ratio * dp);
    }
    std::copy(step_.begin(), step_.begin() + std::ptrdiff_t(n), r.begin());
    factor_.to_velocities(r);
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) u_[k] += r[k], largest = std::max(largest, std::fabs(r[k]));
    return largest;
}

void TreeSolve::add_yield_impulses(std::span<const double> before, std::span<const double> after)
{
    for (const Yield& yield : yields_) {
        double change = 0;
        for (int i = 0; i < yield.count; ++i) {
            const auto at = std::size_t(yield.first + i);
            change += yield.j[i] * (after[at] - before[at]);
        }
        system_->numbers[std::size_t(yield.source)].p -= Real(change / yield.C);
    }
}

void TreeSolve::store_yield()
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) rate += yield.j[i] * u_[std::size_t(yield.first + i)];
        system_->numbers[std::size_t(yield.source)].p = Real((yield.c - rate) / yield.C);
    }
}

void TreeSolve::add_yield(std::span<double> r) const
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) {
            const auto at = std::size_t(yield.first + i);
            rate += yield.j[i] * (u_[at] - solved_[at]);
        }
        for (int i = 0; i < yield.count; ++i) r[std::size_t(yield.first + i)] -= yield.j[i] * rate / yield.C;
    }
}

void TreeSolve::add_yields_to(TreeFactor& factor) const
{
    for (const Yield& yield : yields_)
        for (int i = 0; i < yield.count; ++i)
            for (int k = 0; k <= i; ++k)
                factor.add(yield.first + i, yield.first + k, yield.j[i] * yield.j[k] / yield.C);
}

void TreeSolve::add_yield_momentum(std::span<const double> rates, std::span<double> g) const
{
    for (const Yield& yield : yields_) {
        double rate = 0;
        for (int i = 0; i < yield.count; ++i) rate += yield.j[i] * rates[std::size_t(yield.first + i)];
        for (int i = 0; i < yield.count; ++i) g[std::size_t(yield.first + i)] += yield.j[i] * rate / yield.C;
    }
}

}  // namespace epode
