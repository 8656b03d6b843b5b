// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
//   w = A p - b,  b = c - J v*;   free rows: w = 0
//
// A_FF dp_F = -w_F by Cholesky, which is backward stable: one solution has a residual of rounding size, also
// where redundant rows make A nearly singular. Only where a softness below 1e-11 d had to be raised in the
// factor does it take a few rounds against the true A. Rules of flipping as in active_set.cpp.
// A couples rows of joints that share a body, so each row is zero outside a range of columns, and each row of
// L before its first column there (the envelope): a chain costs what a band matrix costs. Rows are padded to
// even length; inner products run on two lanes with a fixed order of summation.
#include "solve/dense_active_set.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr double kFeasible = 1e-11;
constexpr int kPatience = 5;
constexpr int kMostPasses = 6;
constexpr double kSettled = 1e-13;  // of the problem's scale: nothing left to correct

// x[first..last) . y[first..last), first being even. Inlined: most are short.
[[gnu::always_inline]] inline double inner(const double* x, const double* y, int first, int last)
{
    const auto* a = reinterpret_cast<const DoubleLane*>(x);
    const auto* b = reinterpret_cast<const DoubleLane*>(y);
    DoubleLane s{};
    for (int k = first / 2; k < last / 2; ++k) s += a[k] * b[k];
    const double sum = s[0] + s[1];
    return (last & 1) && last > first ? sum + x[last - 1] * y[last - 1] : sum;
}

bool share_body(const ExactRow& x, const ExactRow& y)
{
    return x.a == y.a || (y.b >= 0 && x.a == y.b) || (x.b >= 0 && (x.b == y.a || x.b == y.b));
}

}  // namespace

bool DenseActiveSet::prepare(const ExactProblem& problem, std::span<const RowBlock> blocks, Arena& arena)
{
    m_ = problem.row_count();
    stride_ = std::size_t(m_ + 1) & ~std::size_t(1);
    A_ = arena.take_zeroed<double>(m_ * int(stride_));
    L_ = arena.take<double>(m_ * int(stride_));
    response_ = arena.take<double>(m_ * 12);
    b_ = arena.take<double>(m_);
    r_ = arena.take<double>(m_);
    w_ = arena.take<double>(m_);
    free_ = arena.take<int>(m_);
    wrong_ = arena.take<int>(m_);
    begin_ = arena.take<int>(m_);
    end_ = arena.take<int>(m_);
    lead_ = arena.take<int>(m_);
    if (arena.failed()) return false;
    for (int i = 0; i < m_; ++i) {
        const auto k = std::size_t(i);
        problem.response(problem.row(i), &response_[12 * k]);
        b_[k] = problem.needed_velocity(i);
        begin_[k] = m_, end_[k] = 0;
    }
    for (std::size_t x = 0; x < blocks.size(); ++x)
        for (std::size_t y = 0; y <= x; ++y)
            if (share_body(problem.row(blocks[x].first), problem.row(blocks[y].first)))
                couple(problem, blocks[x], blocks[y]);
    for (int i = 0; i < m_; ++i) {
        row(i)[i] += problem.row(i).C;
        for (int j = begin_[std::size_t(i)]; j < i; ++j) row(j)[i] = row(i)[j];
    }
    return true;
}

// The block of A between two joints that share a body, x not before y: J_x M^-1 J_y^T over the shared bodies.
void DenseActiveSet::couple(const ExactProblem& problem, const RowBlock& x, const RowBlock& y)
{
    const ExactRow& rx = problem.row(x.first);
    const ExactRow& ry = problem.row(y.first);
    struct Shared {
        int in_x, in_y;  // where the shared body's six numbers begin
    } shared[2];
    int count = 0;
    if (rx.a == ry.a) shared[count++] = {0, 0};
    if (ry.b >= 0 && rx.a == ry.b) shared[count++] = {0, 6};
    if (rx.b >= 0 && rx.b == ry.a) shared[count++] = {6, 0};
    if (rx.b >= 0 && rx.b == ry.b) shared[count++] = {6, 6};

    for (int i = x.first; i < x.first + x.count; ++i) {
        double* Ai = row(i);
        const double* response = &response_[12 * std::size_t(i)];
        const int last = std::min(y.first + y.count, i + 1);
        for (int j = y.first; j < last; ++j) {
            const double* J = problem.row(j).J;
            double s = six_dot(response + shared[0].in_x, J + shared[0].in_y);
            if (count == 2) s += six_dot(response + shared[1].in_x, J + shared[1].in_y);
            Ai[j] = s;
        }
    }
    const auto widen = [this](const RowBlock& block, const RowBlock& other) {
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto k = std::size_t(i);
            begin_[k] = std::min(begin_[k], other.first & ~1);
            end_[k] = std::max(end_[k], other.first + other.count);
        }
    };
    widen(x, y);
    widen(y, x);
}

bool DenseActiveSet::solve(const ExactProblem& problem, BoxState& state, const ActiveSetSettings& settings,
                           int& rounds)
{
    int fewest = m_ + 1, patience = kPatience;
    for (int round = 0; round < settings.rounds; ++round) {
        ++rounds;
        gather_free(state);
        factor(problem);
        for (int pass = 0; pass < kMostPasses && !settled(problem, state); ++pass) solve_free(state);
        const int wrong = find_wrong(problem, state);
        if (wrong == 0) return true;
        const bool progress = wrong < fewest;
        if (progress) fewest = wrong, patience = kPatience;
        int first = 0;
        if (!progress && patience-- <= 0) {
            if (!settings.persistent) return false;
            first = wrong - 1;
        }
        for (int k = first; k < wrong; ++k) state.flip(wrong_[std::size_t(k)]);
    }
    return false;
}

void DenseActiveSet::gather_free(const BoxState& state)
{
    free_count_ = 0;
    for (int i = 0; i < m_; ++i) {
        const auto k = std::size_t(i);
        if (state.tag[k] == BoxState::kFree)
            free_[std::size_t(free_count_++)] = i;
        else
            state.p[k] = state.tag[k] == BoxState::kUpper ? state.hi[k] : state.lo[k];
    }
}

// L L^T = A_FF, rows of L one after the other; the diagonal holds reciprocals.
void DenseActiveSet::factor(const ExactProblem& problem)
{
    int search = 0;
    for (int i = 0; i < free_count_; ++i) {
        const int fi = free_[std::size_t(i)];
        const double* a = row(fi);
        double* l = factor_row(i);
        // Rows of one joint begin at the same column, and later joints seldom before earlier ones.
        const int begin = begin_[std::size_t(fi)];
        while (search > 0 && free_[std::size_t(search - 1)] >= begin) --search;
        while (free_[std::size_t(search)] < begin) ++search;
        const int lead = lead_[std::size_t(i)] = search & ~1;
        for (int j = lead; j < i; ++j) {
            const double* lj = factor_row(j);
            const int first = std::max(lead, lead_[std::size_t(j)]);
            const double known = j > first ? inner(l, lj, first, j) : 0;
            l[j] = (a[free_[std::size_t(j)]] - known) * lj[j];
        }
        const ExactRow& row = problem.row(fi);
        const double pivot = a[fi] + std::max(0.0, row.weight_min - row.C) - inner(l, l, lead, i);
        l[i] = pivot > 0 ? 1 / std::sqrt(pivot) : 1e-150;
    }
}

// w = A p - b for all rows; true when the free ones are zero to rounding.
bool DenseActiveSet::settled(const ExactProblem& problem, const BoxState& state)
{
    for (int i = 0; i < m_; ++i) {
        const auto k = std::size_t(i);
        w_[k] = inner(row(i), state.p.data(), begin_[k], end_[k]) - b_[k];
    }
    double worst = 0;
    for (int i = 0; i < free_count_; ++i)
        worst = std::max(worst, std::fabs(w_[std::size_t(free_[std::size_t(i)])]));
    return worst <= kSettled * problem.scale();
}

// p_F -= A_FF^-1 w_F
void DenseActiveSet::solve_free(BoxState& state)
{
    for (int i = 0; i < free_count_; ++i) {
        const auto k = std::size_t(i);
        const double* l = factor_row(i);
        const double known = inner(l, r_.data(), lead_[k], i);
        r_[k] = (-w_[std::size_t(free_[k])] - known) * l[i];
    }
    for (int i = free_count_ - 1; i >= 0; --i) {
        const auto k = std::size_t(i);
        const double* l = factor_row(i);
        const double x = r_[k] * l[i];
        for (int j = lead_[k]; j < i; ++j) r_[std::size_t(j)] -= l[j] * x;
        state.p[std::size_t(free_[k])] += x;
    }
}

int DenseActiveSet::find_wrong(const ExactProblem& problem, const BoxState& state)
{
    const double tolerance = kFeasible * problem.scale();
    int count = 0;
    for (int i = 0; i < m_; ++i) {
        const auto k = std::size_t(i);
        bool wrong = false;
        if (state.tag[k] == BoxState::kFree) {
            const double slack = tolerance / problem.row(i).d;
            wrong = state.p[k] < state.lo[k] - slack || state.p[k] > state.hi[k] + slack;
        } else if (state.tag[k] != BoxState::kFixed) {
            wrong = state.tag[k] == BoxState::kLower ? w_[k] < -tolerance : w_[k] > tolerance;
        }
        if (wrong) wrong_[std::size_t(count++)] = i;
    }
    return count;
}

}  // namespace epode
