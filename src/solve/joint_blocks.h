// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints as blocks: all rows of a joint are solved together,  (J M^-1 J^T + C) dp = c - J v - C p,  so that a
// joint is exact after one visit and only the coupling between joints is left to iterate. Rows that would
// leave their bounds are put on them and the others solved again. Row by row, a hinge between unequal masses
// would take several sweeps for what the 5x5 system does at once.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/block_ldlt.h"
#include "solve/substep_rows.h"
#include "solve/velocities.h"

namespace epode {

struct JointRow {
    Vec3 lin1, ang1, lin2, ang2;
    Vec3 turn1, turn2;  // I^-1 ang
    Real c, c_relaxed, C;
    Real lo, hi, p;  // of a row with a parent: hi is the coefficient
    int parent;      // within the block, or -1
};

struct JointBlock {
    int first, count;  // in the rows of the set
    int source;        // first row of the system
    int body1, body2;  // into the velocities
    Real inv_mass1, inv_mass2;
    bool bounded;
    Real A[kMaxJointRows][kMaxJointRows];  // J M^-1 J^T + C
    BlockLdlt factors;
};

class JointBlocks {
  public:
    // Takes the blocks that are no contacts, and their bounds and warm start from the numbers; false: out of
    // memory.
    bool prepare(const RowSystem& system, Arena& arena);
    // Reads the rows at the present pose.
    void refresh(const RowSystem& system, const Substep& step);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void sweep(std::span<Velocity> bodies, bool relax);
    void add_impulses(std::span<RowNumbers> numbers) const;  // numbers.p += p
    void describe(std::span<RowNumbers> numbers) const;      // c, C and p of the correcting problem

    // One more visit to joints with rows that rebound and have carried an impulse: they reach their rebound.
    void rebound(const RowSystem& system, std::span<Velocity> bodies);

    bool empty() const { return blocks_.empty(); }

  private:
    void visit(const JointBlock& block, std::span<Velocity> bodies, bool relax);
    void project(const JointBlock& block, const Real* residual, Real* dp);

    std::span<JointBlock> blocks_;
    std::span<JointRow> rows_;
};

}  // namespace epode
