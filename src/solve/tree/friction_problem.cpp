// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/tree/friction_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/hypotenuse.h"

namespace epode {
namespace {

constexpr int kRounds = 8, kPasses = 12, kSweeps = 6;
constexpr int kPatience = 3;  // passes in the first round that do not halve the error: states go round

constexpr double kMostWork = 4e6;  // unknowns cubed, of all systems; then rows of bodies make the step

}  // namespace

bool FrictionProblem::prepare(int rows, Arena& arena)
{
    n_ = rows;
    A_ = arena.take<double>(rows * rows), K_ = arena.take<double>(rows * rows);
    b_ = arena.take<double>(rows), w_ = arena.take<double>(rows), x_ = arena.take<double>(rows);
    column_ = arena.take<double>(rows), limits_ = arena.take<double>(rows);
    p_ = arena.take_zeroed<double>(rows), direction_ = arena.take_zeroed<double>(rows);
    rows_ = arena.take<FrictionRow>(rows), states_ = arena.take<State>(rows);
    unknowns_ = arena.take<Unknown>(rows);
    return !arena.failed();
}

double FrictionProblem::limit(const FrictionRow& row) const
{
    if (frozen_) return limits_[std::size_t(row.parent)] * row.hi;
    const double normal = std::max(p_[std::size_t(row.parent)], 0.0);
    return normal > 0 ? row.hi * normal : 0;  // not infinity times 0
}

bool FrictionProblem::solve(double scale, double wanted, double enough)
{
    scale_ = scale, systems_ = 0;
    evaluate();
    begin_states();
    work_ = 0;
    for (int round = 0; round < kRounds && work_ < kMostWork; ++round) {
        if (iterate(kPasses, kPatience + 2 * round, wanted)) return true;
        sweep(kSweeps << std::min(round, 3));
        begin_states();
        if (round > 0) iterate_frozen();
    }
    measure();
    return residual_ <= wanted && friction_error_ <= enough;
}

// With the bounds of friction that the present normals give, as a convex problem.
void FrictionProblem::iterate_frozen()
{
    for (int i = 0; i < n_; ++i) limits_[std::size_t(i)] = std::max(p_[std::size_t(i)], 0.0);
    frozen_ = true;
    iterate(kPasses, kPatience, 0);
    frozen_ = false;
    evaluate();
    begin_states();
}

FrictionProblem::State FrictionProblem::state_of(int i) const
{
    const FrictionRow& row = rows_[std::size_t(i)];
    const double p = p_[std::size_t(i)], q = p - w_[std::size_t(i)] / A_[std::size_t(i * n_ + i)];
    if (row.parent < 0) {
        if (q <= row.lo) return State::kLow;
        return q >= row.hi ? State::kHigh : State::kFree;
    }
    const State parent = states_[std::size_t(row.parent)];
    if (parent == State::kLow || !(row.hi > 0)) return State::kDead;
    const double L = limit(row);
    return std::fabs(q) > L && L > 0 ? State::kTied : State::kFree;
}

// By what a projected step of each row would do.
void FrictionProblem::begin_states()
{
    for (int i = 0; i < n_; ++i) states_[std::size_t(i)] = State::kFree;
    update_states();
}

// True: something has changed.
bool FrictionProblem::update_states()
{
    bool changed = false;
    for (int i = 0; i < n_; ++i) {
        const auto at = std::size_t(i);
        const FrictionRow& row = rows_[at];
        State now = state_of(i);
        if (row.disc) {
            if (now != State::kDead) {
                const double d = std::max(A_[at * std::size_t(n_ + 1)], A_[(at + 1) * std::size_t(n_ + 1)]);
                const double q[2] = {p_[at] - w_[at] / d, p_[at + 1] - w_[at + 1] / d};
                const double length = hypotenuse(q[0], q[1]), L = limit(row);
                now = length > L && L > 0 ? State::kTied : State::kFree;
                if (now == State::kTied) direction_[at] = q[0] / length, direction_[at + 1] = q[1] / length;
            }
            changed |= states_[at] != now;
            states_[at] = states_[at + 1] = now;
            ++i;
            continue;
        }
        if (now == State::kTied) direction_[at] = p_[at] - w_[at] / A_[at * std::size_t(n_ + 1)] > 0 ? 1 : -1;
        changed |= states_[at] != now;
        states_[at] = now;
    }
    return changed;
}

bool FrictionProblem::iterate(int passes, int patience, double wanted)
{
    double best = std::numeric_limits<double>::infinity();
    for (int pass = 0, stalled = 0; pass < passes && stalled < patience && work_ < kMostWork; ++pass) {
        choose_unknowns();
        if (!solve_unknowns()) return false;
        evaluate();
        measure();
        const double worst = std::max(residual_, friction_error_);
        if (worst <= wanted) return true;
        stalled = worst < 0.5 * best ? 0 : stalled + 1;
        best = std::min(best, worst);
        update_states();
    }
    return false;
}

FrictionProblem::Unknown& FrictionProblem::add_unknown(int row)
{
    Unknown& its = unknowns_[std::size_t(unknown_count_++)];
    its = {row, 1, {row, 0, 0}, {1, 0, 0}, false, 0};
    return its;
}

void FrictionProblem::choose_unknowns()
{
    unknown_count_ = 0;
    int of_parent = -1;  // its unknown
    for (int i = 0; i < n_; ++i) {
        const auto at = std::size_t(i);
        const FrictionRow& row = rows_[at];
        const State state = states_[at];
        if (row.parent < 0) of_parent = -1;
        if (state == State::kFree) {
            add_unknown(i);
            if (row.parent < 0) of_parent = unknown_count_ - 1;
        } else if (state != State::kTied) {
            p_[at] = state == State::kLow ? row.lo : state == State::kHigh ? row.hi : 0;
        } else if (row.disc) {
            tie_disc(i, of_parent);
            ++i;
        } else if (!frozen_ && of_parent >= 0 && unknowns_[std::size_t(of_parent)].count < 3) {
            Unknown& n = unknowns_[std::size_t(of_parent)];
            n.at[n.count] = i, n.factor[n.count++] = row.hi * direction_[at];
        } else {  // more rows than fit are bounded by the present normal
            p_[at] = direction_[at] * limit(row);
        }
    }
}

void FrictionProblem::tie_disc(int i, int of_parent)
{
    const auto at = std::size_t(i);
    const FrictionRow& row = rows_[at];
    const double d[2] = {direction_[at], direction_[at + 1]}, L = limit(row);
    if (frozen_) {
        p_[at] = L * d[0], p_[at + 1] = L * d[1];
        return;
    }
    const double speed = std::max(-(w_[at] * d[0] + w_[at + 1] * d[1]), 0.0);
    if (of_parent >= 0) {
        Unknown& n = unknowns_[std::size_t(of_parent)];
        for (int k = 0; k < 2 && n.count < 3; ++k) n.at[n.count] = i + k, n.factor[n.count++] = row.hi * d[k];
    }
    Unknown& c = add_unknown(i);
    c = {i, 2, {i, i + 1, 0}, {-d[1], d[0], 0}, true, L > 0 ? speed / L : 0};
}

// E^T A G x = -E^T (b + A p of rows that no unknown moves)
bool FrictionProblem::solve_unknowns()
{
    const int m = unknown_count_;
    ++systems_, work_ += double(m) * m * m;
    for (int u = 0; u < m; ++u)
        for (int k = 0; k < unknowns_[std::size_t(u)].count; ++k)
            p_[std::size_t(unknowns_[std::size_t(u)].at[k])] = 0;
    evaluate();
    const auto along = [&](const Unknown& e, const double* column) {
        return e.across ? e.factor[0] * column[e.at[0]] + e.factor[1] * column[e.at[1]] : column[e.row];
    };
    double* const column = column_.data();
    for (int u = 0; u < m; ++u) {
        const Unknown& its = unknowns_[std::size_t(u)];
        const double* const first = row(its.at[0]);
        for (int i = 0; i < n_; ++i) column[i] = its.factor[0] * first[i];
        for (int k = 1; k < its.count; ++k) {
            const double* const other = row(its.at[k]);
            for (int i = 0; i < n_; ++i) column[i] += its.factor[k] * other[i];
        }
        for (int e = 0; e < m; ++e) K_[std::size_t(e * m + u)] = along(unknowns_[std::size_t(e)], column);
        K_[std::size_t(u * m + u)] += its.drag;
        x_[std::size_t(u)] = -along(its, w_.data());
    }
    if (!eliminate(m)) return false;
    for (int u = 0; u < m; ++u)
        for (int k = 0; k < unknowns_[std::size_t(u)].count; ++k)
            p_[std::size_t(unknowns_[std::size_t(u)].at[k])] +=
                unknowns_[std::size_t(u)].factor[k] * x_[std::size_t(u)];
    return true;
}

// Gauss with partial pivoting.
bool FrictionProblem::eliminate(int n)
{
    double* const K = K_.data();
    for (int k = 0; k < n; ++k) {
        int best = k;
        for (int i = k + 1; i < n; ++i)
            if (std::fabs(K[i * n + k]) > std::fabs(K[best * n + k])) best = i;
        if (!(std::fabs(K[best * n + k]) > 0)) return false;
        if (best != k) {
            std::swap_ranges(K + k * n + k, K + (k + 1) * n, K + best * n + k);
            std::swap(x_[std::size_t(k)], x_[std::size_t(best)]);
        }
        const double inverse = 1 / K[k * n + k];
        for (int i = k + 1; i < n; ++i) {
            const double a = K[i * n + k] * inverse;
            if (a == 0) continue;
            for (int j = k + 1; j < n; ++j) K[i * n + j] -= a * K[k * n + j];
            x_[std::size_t(i)] -= a * x_[std::size_t(k)];
        }
    }
    for (int k = n; k-- > 0;) {
        double sum = x_[std::size_t(k)];
        for (int j = k + 1; j < n; ++j) sum -= K[k * n + j] * x_[std::size_t(j)];
        x_[std::size_t(k)] = sum / K[k * n + k];
    }
    return true;
}

void FrictionProblem::evaluate()
{
    std::copy(b_.begin(), b_.end(), w_.begin());
    for (int j = 0; j < n_; ++j) {
        const double p = p_[std::size_t(j)];
        if (p == 0) continue;
        const double* const column = row(j);
        for (int i = 0; i < n_; ++i) w_[std::size_t(i)] += p * column[i];
    }
}

void FrictionProblem::measure()
{
    double worst = 0, friction = 0;
    for (int i = 0; i < n_; ++i) {
        const auto at = std::size_t(i);
        const FrictionRow& row = rows_[at];
        const double d = A_[at * std::size_t(n_ + 1)];
        if (row.disc) {
            const double e = A_[(at + 1) * std::size_t(n_ + 1)], larger = std::max(d, e), L = limit(row);
            const double q[2] = {p_[at] - w_[at] / larger, p_[at + 1] - w_[at + 1] / larger};
            const double length = hypotenuse(q[0], q[1]), share = length > L ? L / length : 1;
            for (int k = 0; k < 2; ++k)
                friction = std::max(friction, larger * std::fabs(p_[at + std::size_t(k)] - share * q[k]));
            ++i;
            continue;
        }
        const double L = row.parent < 0 ? 0 : limit(row);
        const double lo = row.parent < 0 ? row.lo : -L, hi = row.parent < 0 ? row.hi : L;
        const double q = p_[at] - w_[at] / d, off = d * std::fabs(p_[at] - std::min(std::max(q, lo), hi));
        (row.parent < 0 ? worst : friction) = std::max(row.parent < 0 ? worst : friction, off);
    }
    residual_ = worst / scale_, friction_error_ = friction / scale_;
}

void FrictionProblem::sweep(int times)
{
    for (int i = 0; i < n_; ++i) {  // what states have left outside of the bounds
        const auto at = std::size_t(i);
        const FrictionRow& row = rows_[at];
        if (row.parent < 0) p_[at] = std::min(std::max(p_[at], row.lo), row.hi);
    }
    evaluate();
    const auto move = [&](int i, double to) {
        const double change = to - p_[std::size_t(i)];
        if (change == 0) return;
        p_[std::size_t(i)] = to;
        const double* const column = row(i);
        for (int k = 0; k < n_; ++k) w_[std::size_t(k)] += change * column[k];
    };
    for (int sweep = 0; sweep < times; ++sweep)
        for (int i = 0; i < n_; ++i) {
            const auto at = std::size_t(i);
            const FrictionRow& row = rows_[at];
            const double d = A_[at * std::size_t(n_ + 1)];
            if (row.disc) {
                const double larger = std::max(d, A_[(at + 1) * std::size_t(n_ + 1)]), L = limit(row);
                const double q[2] = {p_[at] - w_[at] / larger, p_[at + 1] - w_[at + 1] / larger};
                const double length = hypotenuse(q[0], q[1]), share = length > L ? L / length : 1;
                move(i, share * q[0]), move(i + 1, share * q[1]);
                ++i;
                continue;
            }
            const double L = row.parent < 0 ? 0 : limit(row);
            const double lo = row.parent < 0 ? row.lo : -L, hi = row.parent < 0 ? row.hi : L;
            move(i, std::min(std::max(p_[at] - w_[at] / d, lo), hi));
        }
}

bool FrictionProblem::acts(int i) const { return states_[std::size_t(i)] == State::kFree; }

}  // namespace epode
