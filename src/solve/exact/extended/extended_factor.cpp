// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See extended_factor.h. Right-looking; zeros, as between joints that share no body, are skipped.
#include "solve/exact/extended/extended_factor.h"

namespace epode {
namespace {

constexpr double kMinPivot = 1e-28;  // of d: what rounding may have left of zero

DoubleDouble six_product(const double* x, const double* y)
{
    DoubleDouble sum{};
    for (int k = 0; k < 6; ++k) sum = sum + two_product(x[k], y[k]);
    return sum;
}

// f(body, six numbers of J) for each body of the row.
template <typename F>
void for_each_six(const ExactRow& row, F&& f)
{
    for (const WideTerm6& term : row.terms()) f(term.body, term.J);
    if (row.wide_count > 0) return;
    f(row.a, row.J);
    if (row.b >= 0) f(row.b, row.J + 6);
}

// J_i J_j^T of which one is wide
DoubleDouble wide_product(const ExactRow& i, const ExactRow& j)
{
    DoubleDouble sum{};
    for_each_six(i, [&](int a, const double* x) {
        for_each_six(j, [&](int b, const double* y) {
            if (a == b) sum = sum + six_product(x, y);
        });
    });
    return sum;
}

// J_i J_j^T
DoubleDouble product(const ExactRow& i, const ExactRow& j)
{
    if (i.wide_count > 0 || j.wide_count > 0) return wide_product(i, j);
    DoubleDouble sum{};
    if (i.a == j.a) sum = sum + six_product(i.J, j.J);
    if (i.a == j.b) sum = sum + six_product(i.J, j.J + 6);
    if (i.b < 0) return sum;
    if (i.b == j.a) sum = sum + six_product(i.J + 6, j.J);
    if (i.b == j.b) sum = sum + six_product(i.J + 6, j.J + 6);
    return sum;
}

bool is_zero(DoubleDouble x) { return x.hi == 0; }

}  // namespace

bool ExtendedFactor::prepare(int rows, Arena& arena)
{
    free_ = arena.take<int>(rows);
    L_ = arena.take<DoubleDouble>(int(start(rows)));
    column_ = arena.take<DoubleDouble>(rows);
    return !arena.failed();
}

void ExtendedFactor::factor(const ExactProblem& problem, std::span<const double> free)
{
    count_ = 0;
    for (std::size_t i = 0; i < free.size(); ++i)
        if (free[i] > 0) free_[std::size_t(count_++)] = int(i);
    fill(problem);
    for (int k = 0; k < count_; ++k) eliminate(k, problem.row(free_[std::size_t(k)]).d);
}

void ExtendedFactor::fill(const ExactProblem& problem)
{
    for (int i = 0; i < count_; ++i) {
        const ExactRow& one = problem.row(free_[std::size_t(i)]);
        const std::span<DoubleDouble> to = row(i);
        for (int j = 0; j <= i; ++j) to[std::size_t(j)] = product(one, problem.row(free_[std::size_t(j)]));
        to[std::size_t(i)] = to[std::size_t(i)] + one.C;
    }
}

// Turns the rows below k into those of the Schur complement without k, and column k into that of L.
void ExtendedFactor::eliminate(int k, double d)
{
    const auto at = std::size_t(k);
    DoubleDouble& pivot = row(k)[at];
    if (!(pivot.hi > kMinPivot * d)) pivot = {kMinPivot * d, 0};
    for (int i = k + 1; i < count_; ++i) {
        const std::span<DoubleDouble> to = row(i);
        column_[std::size_t(i)] = to[at];
        if (is_zero(to[at])) continue;
        to[at] = to[at] / pivot;
        const DoubleDouble factor = -to[at];
        for (std::size_t j = at + 1; j <= std::size_t(i); ++j)
            if (!is_zero(column_[j])) to[j] = to[j] + factor * column_[j];
    }
}

void ExtendedFactor::solve(std::span<DoubleDouble> x) const
{
    const auto at = [&](int k) -> DoubleDouble& { return x[std::size_t(free_[std::size_t(k)])]; };
    for (int i = 0; i < count_; ++i)
        for (int j = 0; j < i; ++j) at(i) = at(i) - row(i)[std::size_t(j)] * at(j);
    for (int i = 0; i < count_; ++i) at(i) = at(i) / row(i)[std::size_t(i)];
    for (int i = count_; i-- > 0;)
        for (int j = 0; j < i; ++j) at(j) = at(j) - row(i)[std::size_t(j)] * at(i);
}

}  // namespace epode
