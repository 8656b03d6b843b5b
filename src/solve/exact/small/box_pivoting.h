// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
//   w = A p - b,   lo < p < hi -> w = 0,   p = lo -> w >= 0,   p = hi -> w <= 0
//
// by the symmetric principal pivoting method (Cottle & Dantzig 1968): one row after the other is driven to
// its place while those before stay in theirs. Rows in the basis B have w = 0, the others rest at a bound.
// The tableau is what sweeping B (Goodnight 1979) makes of A, symmetric, its lower half stored:
//
//   G_BB = -A_BB^-1,  G_NB = A_NB A_BB^-1,  G_NN = A_NN - A_NB A_BB^-1 A_BN
//
// With p_i of a row outside B, w_N moves by G_Ni and p_B by -G_Bi; -G_BB also serves for refinement. A sweep
// costs n^2 / 2 multiply-subtracts. For a few dozen rows of contacts, most of them redundant, this takes
// about as many sweeps as rows, where guessing whole sets goes astray in impulses of 1/C. Updating factors of
// A_BB instead costs less for many rows and more for few.
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

class BoxPivoting {
  public:
    bool prepare(int n, Arena& arena);  // A = 0; false: out of memory

    int size() const { return n_; }
    double* row(int i) { return G_.data() + at(i) * stride_; }  // of A; columns up to i count

    // Defines row i: its bounds and its present p and w. Until it is placed it is only monitored.
    void place(int i, double lo, double hi, double p, double w);
    // Updates p and w of a row, placed or not.
    void refresh(int i, double p, double w);

    // Drives all placed rows to where they belong, to within `tolerance` in w. False: too many sweeps.
    bool settle(double tolerance);
    // dp = A_BB^-1 r for rows in the basis, 0 elsewhere; one number per row.
    void correct(std::span<const double> r, std::span<double> dp) const;

    bool basic(int i) const { return state_[at(i)] == kBasic; }
    int sweeps_made() const { return n_ > 0 ? max_sweeps() - sweeps_left_ : 0; }
    double p(int i) const { return basic(i) ? x_[at(i)] : p_[at(i)]; }

  private:
    enum State : unsigned char { kAbsent, kWaiting, kBasic, kLower, kUpper };

    static std::size_t at(int i) { return std::size_t(i); }
    const double* row(int i) const { return G_.data() + at(i) * stride_; }
    int max_sweeps() const { return 8 * n_ + 16; }
    bool drive(int i, double tolerance);
    bool rests_already(int i, double tolerance);
    void move(double length);
    void change_sides(int row);
    int first_to_stop(double direction, double& length);
    void gather(int k);
    void enter(int i);
    void rest(int i, State bound);
    void sweep(int k, double sign);

    int n_ = 0, sweeps_left_ = 0;
    std::size_t stride_ = 0;
    std::span<double> G_, lo_, hi_, p_;  // p: of rows outside B
    // The moving quantities: x is p in B and w outside, and must stay between low and high.
    std::span<double> x_, low_, high_;
    std::span<double> column_, sign_, rate_;  // of G, gathered; -1 in B; of x: direction * sign * column
    std::span<State> state_;
};

}  // namespace epode
