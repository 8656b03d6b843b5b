// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The equations of JointNetwork (joint_network.h) where joints have loops: the matrix J M^-1 J^T + C, with a block
// of six for each joint and one for each pair of joints on a body that moves, factored as it is sparse by the kernel
// of the exact solver (solve/exact/factor/block_cholesky). The dual matrix and not the primal 1 + J^T D J of that
// solver: joints have few rows per body, and C = 0 needs no refinement.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/exact/factor/block_cholesky.h"
#include "solve/exact/factor/symbolic_cache.h"
#include "solve/substeps/network_rows.h"

namespace epode {

class JointLoops {
  public:
    static constexpr int kMaxRows = 6;  // of a joint

    // `symbolic_cache` may be null. False: out of memory.
    bool build(const RowSystem& system, std::span<const NetworkJoint> joints, SymbolicCache* symbolic_cache,
               Arena& arena);
    // True if the factor is sparse enough for this method to pay.
    bool worth() const { return worth_; }
    bool prepare(std::span<const NetworkJoint> joints, Arena& arena);
    void factor(std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows);
    // x, a number for each row: right-hand sides become the solution. Rows out of the factor are not touched.
    void solve(std::span<const NetworkJoint> joints, std::span<const NetworkRow> rows, std::span<double> x);

  private:
    // Two joints on one body: sides 0 and 1 are a joint's first and second body.
    struct Coupling {
        int a, b;
        int side_a, side_b;
        double* block;
        bool transposed;
    };

    bool list_couplings(const RowSystem& system, std::span<const NetworkJoint> joints, Arena& arena);
    void fill_diagonal(const NetworkJoint& joint, std::span<const NetworkRow> rows, double* D) const;
    void fill_coupling(const Coupling& coupling, std::span<const NetworkJoint> joints,
                       std::span<const NetworkRow> rows) const;

    std::span<Coupling> couplings_;
    std::span<double*> diagonals_;
    std::span<double> x_;  // six numbers per joint
    SymbolicLease lease_;
    BlockCholesky A_;
    bool worth_ = false;
};

}  // namespace epode
