// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rows of couplings in sweeps: scalar visits, one row after another, after the batches of joints. With the
// terms J_b of the row's bodies
//
//   dp = w (c - sum J_b v_b - C p) / d,   d = sum J_b M_b^-1 J_b^T + C,   lo <= p + dp <= hi
//
// There are few of them, so lanes and colours would cost more than they save.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/joints/joint_kernels.h"

namespace epode {

class WideRows {
  public:
    // As in JointSetOf.
    bool pack(const RowSystem& system, Arena& arena);
    void load(const RowSystem& system);
    void load_substep(const RowSystem& system, const Substep& step);
    void apply_impulses(std::span<Velocity> bodies) const;
    void sweep(std::span<Velocity> bodies, const JointSweep& how);
    void store_impulses(std::span<RowNumbers> numbers) const;
    void sum_impulses();
    void store_sums(std::span<RowNumbers> numbers) const;
    void describe(std::span<RowNumbers> numbers) const;
    void apply_restitution(const RowSystem& system, std::span<Velocity> bodies);

    bool empty() const { return rows_.empty(); }

  private:
    struct Term {
        int body;
        Real inv_mass;
        Vec3 lin, ang, turn;  // turn = I^-1 ang
    };
    struct WideRow {
        int source, block;  // of the system
        int first, count;   // terms
        Real c, relaxed, C, d;
        Real lo, hi, p, sum;
    };

    void load_terms(const RowSystem& system, WideRow& row);
    void apply(const WideRow& row, Real dp, std::span<Velocity> bodies) const;
    void visit(WideRow& row, std::span<Velocity> bodies, Real target, Real w) const;

    std::span<WideRow> rows_;
    std::span<Term> terms_;  // of each row
};

}  // namespace epode
