// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The island as the exact solver works on it: dynamic bodies only, in double, in coordinates in which every
// body has mass and inertia 1. With M = L L^T, six by six per body,
//
//   v' = L^T v,  J' = J L^-T     so that  M (v - v*) = J^T p  reads  v' - v*' = J'^T p
//
// and with the two operations that all methods share, for a diagonal weight D >= 0 on the rows:
//
//   factor:  H = 1 + J'^T D J'                    (one 6x6 block per body and per touching pair)
//   solve:   x = H^-1 x
//
// In these coordinates a rod's inertia of 1:100 or a neighbour of a thousand times the mass does not affect
// the rounding of a factor, which is eps max(D d). From here on v and J mean v' and J'. Why the primal H and
// not the dual A = J M^-1 J^T (the Schur complement): H has six unknowns per body however many rows act on
// it, stays positive definite whatever the rows' redundancy, and is as sparse as the body graph.
#pragma once

#include <algorithm>
#include <span>

#include "base/arena.h"
#include "math/double_double.h"
#include "rows/row_system.h"
#include "solve/common/work_meter.h"
#include "solve/exact/factor/block_cholesky.h"
#include "solve/exact/factor/symbolic_cache.h"
#include "solve/exact/problem/row_kernels.h"
#include "solve/exact/problem/wide_row.h"

namespace epode {

// Aligned, since clang loads J as lanes of 16 bytes whatever DoubleLane says of its alignment.
struct alignas(16) ExactRow {
    double J[12];       // of body a, then of body b
    double c, C, d;     // d = J J^T + C
    double weight_min;  // smallest compliance that the factor sees, so that C = 0 has a finite weight
    int a, b;           // dynamic bodies; b = -1: only one
    int pair;           // index of the pair of bodies, for H
    int wide_count;     // of a wide row, whose J is 0: terms instead of it
    const WideTerm6* wide;

    WideJacobian terms() const { return {wide, std::size_t(wide_count)}; }
};

// The box problem of one phase and its present iterate.
struct BoxState {
    enum Tag : unsigned char { kLower, kFree, kUpper, kFixed };
    std::span<double> lo, hi, p, v;
    std::span<Tag> tag;

    // Flips a wrong guess: a bound row becomes free, a free row goes to the bound that it has passed.
    void flip(int i)
    {
        const auto k = std::size_t(i);
        tag[k] = tag[k] != kFree ? kFree : p[k] < lo[k] ? kLower : kUpper;
    }
};

class ExactProblem {
  public:
    // False: out of memory. The factor of H is prepared separately: not every method needs it. `work` may be null.
    bool build(const RowSystem& system, WorkMeter* work, Arena& arena);
    // `symbolic_cache` may be null.
    bool build_factor(const RowSystem& system, SymbolicCache* symbolic_cache, const Tasks& tasks,
                      Arena& arena);

    int row_count() const { return int(rows_.size()); }
    int unknowns() const { return int(v_star_.size()); }
    const ExactRow& row(int i) const { return rows_[std::size_t(i)]; }
    // Typical velocity of the problem, m/s: the largest velocity change of a row, but not below a thousandth
    // of the velocities themselves, whose rounding no solver can undercut.
    double scale() const { return scale_; }

    // Rows without compliance that contradict each other have no solution. They get the least compliance that
    // a factor sees anyway; false: there are none.
    bool soften();

    // Computes and factors H with one weight per row; the second with one per place of the packed rows.
    int factor(std::span<const double> D);
    // or, of wide rows, one per row.
    int factor(std::span<const RowGroup> groups, std::span<const double> D, const RowKernels& kernels,
               std::span<const double> wide_weights);
    // Rows of couplings, in their order among all rows.
    std::span<const int> wide_rows() const { return wide_rows_; }
    int factorisations() const { return factorisations_; }
    void solve(std::span<double> x)
    {
        count_work(solve_work_);
        H_.solve(x);
    }
    // Microseconds of one core, of what is not done here.
    void count_work(double time)
    {
        if (work_) work_->spent += time;
    }
    bool gives_up() const { return work_ && work_->exhausted(); }

    std::span<const double> free_motion() const { return v_star_; }  // v*
    // r = v* - v
    void momentum_change(std::span<const double> v, std::span<double> r) const;
    // v = v* + J^T p
    void velocities(std::span<const double> p, std::span<double> v) const;
    // v = v* + momentum; the two may be the same
    void velocities_after(std::span<const double> momentum, std::span<double> v) const;
    // The same for p + low, with J^T (p + low) summed in twice the digits: `sums`, as many as unknowns.
    void velocities(std::span<const double> p, std::span<const double> low, std::span<DoubleDouble> sums,
                    std::span<double> v) const;
    // r = c - J v - C p of the rows for which `free` is positive, 0 for the others. v comes from sums = J^T
    // (p + low), and everything has twice the digits.
    void defect(std::span<const double> p, std::span<const double> low, std::span<const double> free,
                std::span<DoubleDouble> sums, std::span<DoubleDouble> r) const;
    // Ap = J J^T p + C p, with J^T p summed in the same way; `v` is scratch.
    void apply(std::span<const double> p, std::span<DoubleDouble> sums, std::span<double> v,
               std::span<double> Ap) const;

    static double jv(const ExactRow& row, const double* v);        // J v
    static void add_jt(const ExactRow& row, double s, double* x);  // x += J^T s

    // Natural residual, relative to scale(), for bounds lo and hi; `v` is scratch.
    double residual(const BoxState& state, std::span<double> v) const;
    // The same with velocities that belong to state.p and may carry more digits than it.
    double residual_at(const BoxState& state, std::span<const double> v) const;

    // Stores the answer in the system: impulses, and velocities computed from the impulses and not from an
    // iterate, so that momentum is conserved to rounding.
    void store(RowSystem& system, std::span<const double> p, std::span<const double> v) const;

  private:
    // M = L L^T of one body: the root of the mass; of the inertia l10 l20 l21 and the reciprocals of the
    // diagonal.
    struct BodyRoot {
        double root, inv_root;
        double l10, l20, l21, r0, r1, r2;
    };

    void begin_factor();
    void note_work();
    void add_wide(WideJacobian row, double weight);
    bool take_wide(const RowSystem& system, Arena& arena);
    void fill_wide_row(int i, const RowNumbers& n, const RowBlock& block, const RowSystem& system,
                       ExactRow& out);
    bool number_bodies(const RowSystem& system, Arena& arena);
    void fill_rows(const RowSystem& system);
    static BodyRoot root_of(const SolverBody& body);
    static void to_root(const BodyRoot& root, double* six);    // six = L^-1 six, of a row of J
    static void from_root(const BodyRoot& root, double* six);  // six = L^-T six, of a change of velocity
    void sum_impulses(std::span<const double> p, std::span<const double> low,
                      std::span<DoubleDouble> sums) const;
    void fill_row(const Row& row, const RowNumbers& n, const RowBlock& block, const RowSystem& system,
                  ExactRow& out);

    std::span<int> dynamic_;  // island body -> dynamic index or -1
    std::span<BodyRoot> roots_;
    std::span<double> v_star_;
    std::span<ExactRow> rows_;
    std::span<PairBlocks> pairs_;  // one per block of rows
    SymbolicLease symbolic_;
    BlockCholesky H_;
    std::span<int> wide_rows_;
    std::span<WideTerm6> wide_terms_;  // of the system's terms, those of dynamic bodies
    double scale_ = 1;
    int factorisations_ = 0;
    WorkMeter* work_ = nullptr;
    double factor_work_ = 0,
           solve_work_ = 0;  // microseconds, with the passes over the rows that go with them
};

// d (p - clip(p - w/d, lo, hi)) without that difference: where rows contradict each other, impulses have any size, and w
// may be below their rounding.
inline double violation_of(double w, double d, double p, double lo, double hi)
{
    return std::min(std::max(w, d * (p - hi)), d * (p - lo));
}

inline double six_dot(const DoubleLane* a, const DoubleLane* b)
{
    const DoubleLane s = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return s[0] + s[1];
}
inline double six_dot(const double* x, const double* y)
{
    return six_dot(reinterpret_cast<const DoubleLane*>(x), reinterpret_cast<const DoubleLane*>(y));
}

inline double ExactProblem::jv(const ExactRow& row, const double* v)
{
    if (row.wide_count > 0) return wide_product(row.terms(), v);
    const double s = six_dot(row.J, v + 6 * row.a);
    return row.b < 0 ? s : s + six_dot(row.J + 6, v + 6 * row.b);
}

inline void ExactProblem::add_jt(const ExactRow& row, double s, double* x)
{
    if (row.wide_count > 0) return add_wide_transposed(row.terms(), s, x);
    const auto six = [s](const double* J, double* y) {
        const auto* a = reinterpret_cast<const DoubleLane*>(J);
        auto* b = reinterpret_cast<DoubleLane*>(y);
        for (int i = 0; i < 3; ++i) b[i] += a[i] * s;
    };
    six(row.J, x + 6 * row.a);
    if (row.b >= 0) six(row.J + 6, x + 6 * row.b);
}

}  // namespace epode
