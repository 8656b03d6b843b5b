// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All joints of an island as one block. What JointSet does for the rows of one joint,
//
//   (J M^-1 J^T + C) dp = c - J v - C p,
//
// is done here for the rows of all joints at once, so that no iteration between joints remains however
// unequal the masses are. Joints of the same two bodies are one. Where they are trees, each tree is eliminated
// from its leaves (joint_forest.h), else all are factored together (joint_loops.h): once per pose; every visit
// solves with it.
//
// Bounds: a row whose impulse would leave them is taken out of the factor, and the rest is solved again. A stop is
// held on its bound until it pulls away from there. Friction and drives of limited force are swept from then on:
// before each solution their own equation is solved within its bounds, as a sweep does. Both are exact steps of
// one descent, of a row and of all others, so a visit cannot make matters worse. What sweeps take off its
// bound goes into the factor, once a step. Rows of friction change sides in every visit of a pile of figures: held
// and released as stops are, they had cost a factor each time.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/joints/joint_kernels.h"
#include "solve/substeps/joint_forest.h"
#include "solve/substeps/joint_loops.h"
#include "solve/substeps/network_rows.h"

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

    int factorisations() const;  // of the whole, rounded up

  private:
    // Joints that are factored together: a few trees, or all.
    struct Group {
        int first, last;
        bool stale;
    };
    bool list_joints(const RowSystem& system, int most_rows, Arena& arena);
    static NetworkJoint network_joint(const RowBlock& piece, const RowSystem& system);
    static bool extend(NetworkJoint& joint, const RowBlock& piece, const RowSystem& system, int most_rows);
    bool sort_joints(Arena& arena);
    std::span<NetworkRow> rows_of(const NetworkJoint& joint) const
    {
        return rows_.subspan(std::size_t(joint.first), std::size_t(joint.count));
    }
    void load_row(const Row& row, const SolverBody* const (&bodies)[2], const Substep& step,
                  NetworkRow& out) const;
    void pack_row(const RowNumbers& n, const NetworkJoint& joint, NetworkRow& row);
    std::span<NetworkJoint> joints_of(const Group& group)
    {
        return joints_.subspan(std::size_t(group.first), std::size_t(group.last - group.first));
    }
    void factor(std::size_t group);

    void bounds(const NetworkRow& row, Real& lo, Real& hi) const;
    void visit(std::size_t group, std::span<Velocity> bodies, bool relax);
    void sweep_rows(Group& group, std::span<Velocity> bodies, bool relax);
    void solve(std::size_t group, std::span<Velocity> bodies, bool relax);
    bool leave_factor(Group& group, std::span<Velocity> bodies);
    bool release(Group& group, std::span<const Velocity> bodies, bool relax);

    static Real velocity(const NetworkRow& row, const NetworkJoint& joint, std::span<const Velocity> bodies);
    static void apply(const NetworkRow& row, const NetworkJoint& joint, Real dp, std::span<Velocity> bodies);

    const RowSystem* system_ = nullptr;
    std::span<NetworkJoint> joints_;
    std::span<NetworkRow> rows_;
    std::span<Group> groups_;
    std::span<double> x_;  // a number for each row
    JointForest forest_;
    JointLoops loops_;
    bool worth_ = false, bounded_ = false;
    int factored_ = 0;  // joints
};

}  // namespace epode
