// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The problem of a step (rows/row_system.h) of an island whose joints are trees, in joint coordinates: the rows that hold joints are
// left out, since v = T u satisfies them, and all others act on u,
//
//   H (u - u*) = sum j p,   u* = H^-1 (T^T M v* + sum j c / C),   j = T^T J^T
//   y = D^-1/2 L^-T j,  z = D^1/2 L u:   w = Y z + C p - c,  z = z* + Y^T p,  A = Y Y^T + C
//
// The answer is that of the other exact solvers where joints are closed: v and p of all rows, those of joints from the momentum that
// each hands on to what hangs on it. Rows that only yield (armature, springs, dampers, drives without limits) and move one joint are
// part of H. Equality: A = J M^-1 J^T restricted to the motions that joints allow.
#pragma once

#include "solve/solver.h"
#include "solve/tree/dense_factor.h"
#include "solve/tree/friction_problem.h"
#include "solve/tree/joint_tree.h"
#include "solve/tree/tree_factor.h"

namespace epode {

// Of A_ii: the least compliance of rows that close loops, which hold a link twice where the loop is plane.
inline constexpr double kRedundant = sizeof(Real) == 8 ? 1e-12 : 1e-7;

class TreeSolve {
  public:
    static constexpr int kMaxRows = 120;  // besides those of joints and those that yield

    // False: out of memory. Of a tree (JointTree::build) with the system's v* in its bodies. closing: of each row of the system, whether it
    // holds a joint together that is no branch. max_rows: more do not fit.
    bool prepare(RowSystem& system, const JointTree& tree, std::span<const bool> closing, int max_rows,
                 Arena& arena);
    bool fits() const { return fits_; }  // false: there are too many rows

    // Is no eigenvalue of H^-1 T^T S T above that one? S, of links: what a step adds to moments of inertia, which moves no centre. Behind
    // prepare().
    bool resolves(std::span<const Sym3> swings, double largest);

    // The answer's p of rows but not those of joints, and u. False: it was not found, and nothing has changed.
    bool solve(SolveReport& report);

    const JointTree& tree() const { return *tree_; }
    std::span<const double> u() const { return u_; }
    std::span<const double> solution() const { return solved_; }  // u before it was corrected
    // Three dofs of a root that is free.
    void add_to_root(const TreeLink& root, Vec3 dv)
    {
        for (int i = 0; i < 3; ++i) u_[std::size_t(root.first + i)] += double(dv[i]);
    }
    // v = T u to the bodies.
    void store_velocities();

    // With the rows that act kept as they move, J du + C dp = 0, or the excess that is set of a row: u += du of H du = r + sum j dp, and dp to their p, by an iteration
    // that is extrapolated from the last ones. `r` is destroyed. Returns the largest du.
    bool prepare_corrections(Arena& arena);  // false: rows contradict each other, or out of memory
    void set_excess(int source, double rate)
    {
        if (const int i = row_of_source_[std::size_t(source)]; i >= 0) excess_[std::size_t(i)] = rate;
    }
    double correct(std::span<double> r);
    // r -= j (j . (u - u of the solution)) / C of the rows that yield.
    void add_yield(std::span<double> r) const;
    // Impulses of the rows that yield at the present u; and what is added to them where rates of dofs change once more.
    void store_yield();
    void add_yield_impulses(std::span<const double> before, std::span<const double> after);

    // Of impulses that rows exert, less those of joints: f_link -= J^T p.
    void subtract_impulses(std::span<Spatial> of_links) const;
    // p of the joints' rows, which hand on these impulses, about their anchors, to their links.
    void store_joint_impulses(std::span<const Spatial> impulses);

    // A problem of poses: the least displacement dq with  j . dq >= e  of rows with one bound, `errors`: e by row of the system, or
    // -infinity where it holds nothing. False: not found. The rows are those of the step.
    bool least_displacement(std::span<const double> errors, std::span<double> dq, Arena& arena);
    int row_count() const { return int(rows_.size()); }
    int source(int i) const { return rows_[std::size_t(i)].source; }
    TreeFactor& factor() { return factor_; }

    // H of the same yields at poses where the tree has moved; c of their rows becomes what `rate` has of each dof.
    void add_yields_to(TreeFactor& factor) const;
    void add_yield_momentum(std::span<const double> rates, std::span<double> g) const;

    // j of a row of the tree as it is placed now.
    void jacobian(const RowBlock& block, const Jacobian& row, std::span<double> j) const;

  private:
    struct TreeRow {
        int source;  // of the system
        int block;
        double ratio;  // of the second row of a disc: its bound over that of the first
    };
    struct Yield {
        int source, first, count;
        double C, c;
        double j[6];
    };

    bool collect(Arena& arena);
    bool take_yield(const RowBlock& block, int source);
    bool is_joint_of(int link, int parent) const;
    bool is_disc(int i) const;
    void make_disc(int i);
    void add_chain(int link, const Spatial& f, std::span<double> j) const;
    void add_own(const TreeLink& link, const Spatial& f, std::span<double> j) const;
    Spatial on_body(int link, Vec3 force, Vec3 torque) const;
    double kinematic_part(const RowBlock& block, const Row& row) const;
    void write_rows();
    void write_row(int i);
    double* y(int i) { return Y_.data() + std::size_t(i) * u_.size(); }
    const double* y(int i) const { return Y_.data() + std::size_t(i) * u_.size(); }
    bool solve_problem(SolveReport& report);
    bool solve_phases();
    void bind_parents();
    void store_impulses();
    double trace_of(std::span<const Sym3> swings);
    double largest_of(std::span<const Sym3> swings);
    void find_correction(std::span<double> r);
    void extrapolate();

    static constexpr int kHistory = 2;

    RowSystem* system_ = nullptr;
    const JointTree* tree_ = nullptr;
    TreeFactor factor_;
    FrictionProblem problem_;
    std::span<TreeRow> rows_;
    std::span<Yield> yields_;
    std::span<int> row_of_source_;
    std::span<const bool> closing_;
    DenseFactor acting_factor_;
    std::span<double> u_, z_, solved_, Y_, excess_, corrected_;  // excess_: by row; corrected_: sum of y dp
    // Corrections z and p before and after extrapolation, the last one first, and their changes.
    std::span<double> correction_, step_, steps_[kHistory], changes_[kHistory];
    int history_ = 0;
    std::span<double> spins_[3];
    std::span<int> acting_;
    std::span<Spatial> scratch_;
    int acting_count_ = 0;
    double scale_ = 1;
    bool fits_ = false;
};

}  // namespace epode
