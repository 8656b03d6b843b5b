// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All joints of an island as one block. What JointSet does for the rows of one joint,
//
//   (J M^-1 J^T + C) dp = c - J v - C p,
//
// is done here for the rows of all joints at once, so that no iteration between joints remains however
// unequal the masses are. The matrix has a block of six for each joint (several for a joint with more rows)
// and one for each pair of joints on a body that moves. It is as sparse as the joints' graph, and a tree of
// joints has no fill. The kernel of the exact solver (solve/exact/factor/block_cholesky) factors it once per
// pose; every visit solves with it. The dual matrix and not the primal 1 + J^T D J of the exact solver:
// joints have few rows per body, C = 0 needs no refinement, and a row on its bound costs one row and column
// of ones. Bounds: a row that leaves them is held on its bound, and a held row that pulls away from it is
// released, for a few rounds; which rows are held is remembered from visit to visit.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/exact/factor/block_cholesky.h"
#include "solve/exact/factor/symbolic_cache.h"
#include "solve/joints/joint_kernels.h"

namespace epode {

class JointNetwork {
  public:
    static constexpr bool kHasBothEnds = true;  // of a pass: joints stay exact, contacts iterate

    // Analyses the structure. `symbolic_cache` may be null. False: out of memory.
    bool analyse(const RowSystem& system, SymbolicCache* symbolic_cache, Arena& arena);
    // True if the factor is sparse enough for this method to pay. There may also be no joints at all.
    bool worth() const { return worth_; }

    // As in JointSet, after `analyse`.
    bool pack(const RowSystem& system, Arena& arena);
    // The joints evaluate their rows again.
    bool follow(const RowSystem&, const Substep&, std::span<const Velocity>, Arena&) { return true; }
    void turn(const RowSystem&) {}  // rows are those of the joints
    void load_substep(const RowSystem& system, const Substep& step);
    void apply_impulses(std::span<Velocity> bodies) const;
    void sweep(std::span<Velocity> bodies, const JointSweep& how);
    void sum_impulses();
    void store_sums(std::span<RowNumbers> numbers) const;
    void describe(std::span<RowNumbers> numbers, std::span<Row> rows) const;
    void apply_restitution(const RowSystem& system, std::span<Velocity> bodies);

    int factorisations() const { return factorisations_; }

  private:
    enum class Hold : unsigned char { kFree, kLow, kHigh };
    struct NetworkRow {
        Vec3 lin[2], ang[2], turn[2];  // turn = I^-1 ang
        Real c, c_relaxed, C;
        Real lo, hi, p;  // of a row with a parent: hi is the coefficient
        Real sum;        // of p over the earlier substeps
        int parent;      // in the rows of the network, or -1
        Hold hold;
    };
    struct NetworkJoint {
        int first, count, source;
        int body[2];  // into the velocities
        Real inv_mass[2];
        double* diagonal;
    };
    // Two joints on one body: sides 0 and 1 are a joint's first and second body.
    struct Coupling {
        int a, b;
        int side_a, side_b;
        double* block;
        bool transposed;
    };

    bool list_joints(const RowSystem& system, Arena& arena);
    bool list_couplings(const RowSystem& system, Arena& arena);
    std::span<NetworkRow> rows_of(const NetworkJoint& joint) const
    {
        return rows_.subspan(std::size_t(joint.first), std::size_t(joint.count));
    }
    void load_row(const Row& row, const SolverBody* const (&bodies)[2], const Substep& step,
                  NetworkRow& out) const;
    void pack_row(const RowNumbers& n, const NetworkJoint& joint, NetworkRow& row);
    void factor();
    void fill_diagonal(const NetworkJoint& joint);
    void fill_coupling(const Coupling& coupling);

    Real bound(const NetworkRow& row) const;
    void bounds(const NetworkRow& row, Real& lo, Real& hi) const;
    void put_on_bounds(std::span<Velocity> bodies);
    void solve_free(std::span<Velocity> bodies, bool relax);
    bool change_holds(std::span<Velocity> bodies, bool relax, bool may_let_go);

    static Real velocity(const NetworkRow& row, const NetworkJoint& joint, std::span<const Velocity> bodies);
    static void apply(const NetworkRow& row, const NetworkJoint& joint, Real dp, std::span<Velocity> bodies);

    std::span<NetworkJoint> joints_;
    std::span<NetworkRow> rows_;
    std::span<Coupling> couplings_;
    std::span<double> x_;  // six numbers per joint
    SymbolicLease lease_;
    BlockCholesky A_;
    bool worth_ = false, bounded_ = false, stale_ = true;
    int factorisations_ = 0;
};

}  // namespace epode
