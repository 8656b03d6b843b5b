// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of contacts, stops and motors on one dense matrix, with Coulomb's friction:
//
//   w = A p + b,   A = Y Y^T + C positive definite
//   a row with bounds     lo <= p <= hi:  w = 0 between, w >= 0 at lo, w <= 0 at hi
//   a row with a parent   the same with the bounds -+ mu p_n of its normal
//   a disc of two rows    |p_t| <= mu p_n:  w_t = 0 inside, w_t = -s p_t with s >= 0 on the rim
//
// Semismooth Newton (Alart & Curnier, "A mixed formulation for frictional contact problems", 1991) from the states that the impulses
// of the last step suggest: rows at a bound keep it, friction on its rim is tied to its normal, p_t = mu p_n d + p_c c, with the
// direction d that p_t - w_t / A has, and across it w_c + (s / mu p_n) p_c = 0; one linear system gives all others. Where states do not
// settle within some systems, Gauss-Seidel sweeps with projections choose them again, and systems with friction's bounds kept at those of
// the present normals, which are convex. Steady contacts take one system.
#pragma once

#include <span>

#include "base/arena.h"

namespace epode {

struct FrictionRow {
    double lo, hi;      // of p; with a parent: hi = mu
    int parent = -1;    // a row before it
    bool disc = false;  // together with the row after it, whose `second` is set
    bool second = false;
};

class FrictionProblem {
  public:
    bool prepare(int rows, Arena& arena);  // False: out of memory. p begins as 0

    int size() const { return n_; }
    double* row(int i) { return A_.data() + std::size_t(i) * std::size_t(n_); }  // all columns
    std::span<double> b() { return b_; }
    std::span<double> p() { return p_; }
    std::span<FrictionRow> rows() { return rows_; }

    // To a natural residual of `wanted` times `scale`, or, where friction is Coulomb's, of `enough` at least. False: not reached.
    bool solve(double scale, double wanted, double enough);
    double residual() const { return residual_; }  // of the last solution, relative to the scale
    double friction_error() const { return friction_error_; }
    int systems() const { return systems_; }
    // Does the row neither rest at a bound nor slide?
    bool acts(int i) const;

  private:
    enum class State : unsigned char { kFree, kLow, kHigh, kDead, kTied };
    struct Unknown {  // p of up to three rows follows from it
        int row;      // its equation: w of the row, or across the direction of a disc
        int count;
        int at[3];
        double factor[3];
        bool across;  // equation and unknown are those across the disc that begins at `row`
        double drag;  // on the equation's diagonal
    };

    void begin_states();
    void iterate_frozen();
    bool iterate(int passes, int patience, double wanted);
    Unknown& add_unknown(int row);
    void choose_unknowns();
    void tie_disc(int i, int of_parent);
    bool solve_unknowns();
    bool eliminate(int n);
    void evaluate();
    bool update_states();
    void sweep(int times);
    void measure();
    double limit(const FrictionRow& row) const;
    State state_of(int i) const;

    int n_ = 0, systems_ = 0;
    double scale_ = 1, work_ = 0, residual_ = 0, friction_error_ = 0;
    std::span<double> A_, b_, p_, w_, K_, x_, column_, direction_;  // direction_: of a disc at its two rows
    std::span<double> limits_;  // normals that bound friction while it is frozen
    bool frozen_ = false;
    std::span<FrictionRow> rows_;
    std::span<State> states_;
    std::span<Unknown> unknowns_;
    int unknown_count_ = 0;
};

}  // namespace epode
