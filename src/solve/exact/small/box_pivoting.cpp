// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sweeping row k in, and out again with the other sign, D = G_kk:
//
//   G_kk' = -1/D,   G_ik' = +- G_ik / D,   G_ij' = G_ij - G_ik G_jk / D
//
// Rows with G_ik = 0 are skipped: bodies that do not touch stay uncoupled.
#include "solve/exact/small/box_pivoting.h"

#include <algorithm>
#include <cmath>

#include "solve/exact/factor/block_cholesky.h"

namespace epode {
namespace {

DoubleLane* lanes(std::span<double> x) { return reinterpret_cast<DoubleLane*>(x.data()); }

}  // namespace

bool BoxPivoting::prepare(int n, Arena& arena)
{
    n_ = n;
    stride_ = std::size_t(n + 3) & ~std::size_t(3);
    sweeps_left_ = max_sweeps();
    const auto rows = arena.take_zeroed<double>(int(stride_ * (stride_ + 9)));
    state_ = arena.take_zeroed<State>(n);
    if (arena.failed()) return false;
    G_ = rows.first(stride_ * stride_);
    std::size_t next = G_.size();
    for (std::span<double>* vector : {&lo_, &hi_, &p_, &x_, &low_, &high_, &sign_, &column_, &rate_}) {
        *vector = rows.subspan(next, stride_);
        next += stride_;
    }
    std::fill(low_.begin(), low_.end(), -HUGE_VAL);
    std::fill(high_.begin(), high_.end(), HUGE_VAL);
    std::fill(sign_.begin(), sign_.end(), 1.0);
    return true;
}

void BoxPivoting::place(int i, double lo, double hi, double p, double w)
{
    lo_[at(i)] = lo, hi_[at(i)] = hi;
    state_[at(i)] = kWaiting;
    refresh(i, p, w);
}

void BoxPivoting::refresh(int i, double p, double w)
{
    p_[at(i)] = p;
    x_[at(i)] = basic(i) ? p : w;
}

bool BoxPivoting::settle(double tolerance)
{
    for (int i = 0; i < n_; ++i)
        if (state_[at(i)] == kWaiting && !drive(i, tolerance)) return false;
    return true;
}

// Is p_i at a bound that w_i holds it at?
bool BoxPivoting::rests_already(int i, double tolerance)
{
    const auto k = at(i);
    if (p_[k] <= lo_[k] && x_[k] >= -tolerance) return rest(i, kLower), true;
    if (p_[k] >= hi_[k] && x_[k] <= tolerance) return rest(i, kUpper), true;
    return false;
}

// Moves all that follows the row that is driven by this length.
void BoxPivoting::move(double length)
{
    DoubleLane *x = lanes(x_), *rate = lanes(rate_);
    for (DoubleLane* end = x + stride_ / 2; x < end; ++x, ++rate) *x += *rate * length;
}

// The row has reached an end of its range.
void BoxPivoting::change_sides(int row)
{
    const bool below = rate_[at(row)] < 0;
    gather(row);
    if (!basic(row)) return enter(row);
    sweep(row, -1);
    p_[at(row)] = below ? lo_[at(row)] : hi_[at(row)];
    x_[at(row)] = 0;
    rest(row, below ? kLower : kUpper);
}

// Moves p_i against w_i until w_i = 0 or p_i is at a bound; rows that reach their own end on the way change
// sides.
bool BoxPivoting::drive(int i, double tolerance)
{
    const auto k = at(i);
    while (true) {
        if (rests_already(i, tolerance)) return true;
        if (sweeps_left_-- <= 0) return false;
        gather(i);
        const double direction = x_[k] < 0 ? 1 : -1;
        const double distance = direction > 0 ? hi_[k] - p_[k] : p_[k] - lo_[k];
        double length = std::fabs(x_[k]) / column_[k];
        const bool meets_bound = distance < length;
        if (meets_bound) length = distance;
        const int first = first_to_stop(direction, length);
        move(length);
        p_[k] += direction * length;
        if (first < 0 && !meets_bound) return enter(i), true;
        if (first < 0) {
            p_[k] = direction > 0 ? hi_[k] : lo_[k];
            return rest(i, direction > 0 ? kUpper : kLower), true;
        }
        change_sides(first);
    }
}

// The row that leaves its range first within `length`, and when; -1: none does.
int BoxPivoting::first_to_stop(double direction, double& length)
{
    DoubleLane* rate = lanes(rate_);
    const DoubleLane *column = lanes(column_), *sign = lanes(sign_), *x = lanes(x_);
    const DoubleLane *low = lanes(low_), *high = lanes(high_);
    double reach = length;
    int first = -1;
    for (std::size_t q = 0, end = stride_ / 2; q < end; ++q) {
        rate[q] = column[q] * sign[q] * direction;
        const DoubleLane to = x[q] + rate[q] * reach;
        const auto out = (to < low[q]) | (to > high[q]);
        if (!(out[0] | out[1])) continue;
        for (std::size_t j = 2 * q; j < 2 * q + 2; ++j) {
            const double edge = rate_[j] < 0 ? low_[j] : high_[j];
            if (!(rate_[j] < 0 ? x_[j] + reach * rate_[j] < edge : x_[j] + reach * rate_[j] > edge)) continue;
            reach = std::max(0.0, (edge - x_[j]) / rate_[j]);
            first = int(j);
        }
    }
    length = reach;
    return first;
}

void BoxPivoting::gather(int k)
{
    std::copy_n(row(k), k + 1, column_.begin());
    for (int i = k + 1; i < n_; ++i) column_[at(i)] = row(i)[k];
}

// The column of the row that changes sides has been collected.
void BoxPivoting::enter(int i)
{
    sweep(i, 1);
    const auto k = at(i);
    state_[k] = kBasic;
    sign_[k] = -1;
    x_[k] = p_[k], low_[k] = lo_[k], high_[k] = hi_[k];
}

void BoxPivoting::rest(int i, State bound)
{
    const auto k = at(i);
    state_[k] = bound;
    sign_[k] = 1;
    low_[k] = bound == kLower ? 0 : -HUGE_VAL;
    high_[k] = bound == kLower ? HUGE_VAL : 0;
}

// Four rows at a time, up to the diagonal and a little beyond; row and column k are garbage afterwards.
void BoxPivoting::sweep(int k, double sign)
{
    const double* column = column_.data();
    const double inverse = 1 / column[k];
    for (int i = 0; i < int(stride_); i += 4) {
        const double f0 = column[i] * inverse, f1 = column[i + 1] * inverse;
        const double f2 = column[i + 2] * inverse, f3 = column[i + 3] * inverse;
        if (f0 == 0 && f1 == 0 && f2 == 0 && f3 == 0) continue;
        const DoubleLane* from = reinterpret_cast<const DoubleLane*>(column);
        DoubleLane* r0 = reinterpret_cast<DoubleLane*>(row(i));
        DoubleLane* r1 = reinterpret_cast<DoubleLane*>(row(i + 1));
        DoubleLane* r2 = reinterpret_cast<DoubleLane*>(row(i + 2));
        DoubleLane* r3 = reinterpret_cast<DoubleLane*>(row(i + 3));
        for (int q = 0; q < i / 2 + 2; ++q) {
            const DoubleLane c = from[q];
            r0[q] -= c * f0, r1[q] -= c * f1, r2[q] -= c * f2, r3[q] -= c * f3;
        }
    }
    for (int j = 0; j < k; ++j) row(k)[j] = sign * inverse * column[j];
    for (int i = k + 1; i < n_; ++i) row(i)[k] = sign * inverse * column[i];
    row(k)[k] = -inverse;
}

void BoxPivoting::correct(std::span<const double> r, std::span<double> dp) const
{
    std::fill(dp.begin(), dp.end(), 0.0);
    for (int i = 0; i < n_; ++i) {
        if (!basic(i)) continue;
        const double* from = row(i);
        double sum = from[i] * r[at(i)];
        for (int j = 0; j < i; ++j) {
            if (!basic(j)) continue;
            sum += from[j] * r[at(j)];
            dp[at(j)] -= from[j] * r[at(i)];
        }
        dp[at(i)] -= sum;
    }
}

}  // namespace epode
