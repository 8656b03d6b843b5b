// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints packed for sweeping (solve/joints/joint_batch.h) and what is done to all of them. Every joint gets a
// colour, so that joints of one colour share no dynamic body: the smallest that its bodies still have, in the
// order of the joints. Joints of one colour and one shape of rows make batches of up to eight. Sweeps go
// colour by colour, always in the same direction: forwards and backwards by turns, as symmetric SOR would,
// made a hanging net part twice as far. Since colours depend on the neighbours alone, an island has the same
// answer whether it is packed alone or beside others. Which joints are packed in floats is the business of
// solve/joints/joint_lanes.h.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"
#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/joints/joint_kernels.h"

namespace epode {

// L: Lanes or FloatLanes.
template <typename L>
class JointSetOf {
  public:
    explicit JointSetOf(const JointKernels& kernels = *joint_kernels().back())
        : machine_(&kernels), kernels_(&kernels.of(static_cast<const L*>(nullptr)))
    {}

    // Takes these blocks, none of which are contacts, with bounds and warm start from the numbers; false: out
    // of memory.
    bool pack(const RowSystem& system, std::span<const int> blocks, Arena& arena);
    void load(const RowSystem& system);  // what the numbers ask for
    // Instead, in substeps: at first, from rows, poses and velocities of the beginning, the facts of all
    // blocks that the kernels follow (solve/joints/joint_follow.inc), which are marked; false: out of memory.
    // Then, as often as poses change, what followed rows ask for at these, and what the others say; and what
    // the impulses of the substep before do to the bodies, if there are any.
    bool follow(const RowSystem& system, const Substep& step, std::span<const Velocity> bodies, Arena& arena);
    void load_substep(const RowSystem& system, const Substep& step, std::span<Velocity> bodies);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void sweep(std::span<Velocity> bodies, const JointSweep& how);
    // Of FloatLanes, the same where velocities have been rounded already.
    void apply_impulses(std::span<FloatVelocity> bodies) const;
    void sweep(std::span<FloatVelocity> bodies, const JointSweep& how);
    void store_impulses(std::span<RowNumbers> numbers) const;
    void sum_impulses();  // sum += p, after each substep
    void store_sums(std::span<RowNumbers> numbers) const;
    // c, C and p of the correcting problem, and the Jacobians of followed rows.
    void describe(std::span<RowNumbers> numbers, std::span<Row> rows) const;

    // One more visit to joints with rows that rebound and have carried an impulse: they reach their rebound.
    void apply_restitution(const RowSystem& system, std::span<Velocity> bodies);

    bool empty() const { return batches_.empty(); }

  private:
    using Number = typename L::Number;

    // Which joint is in a lane, and which of its rows is where: free rows come first.
    struct Source {
        int block;  // -1: none
        int first;  // row of the system
        unsigned char row[kMaxJointRows];
    };
    struct Shape {
        RowForm form;
        int rows, bounded;
        bool operator==(const Shape&) const = default;
    };
    // A joint while it is sorted.
    struct Joint {
        int block, colour, shape;
    };

    static Shape shape_of(const RowSystem& system, const RowBlock& block);
    void colour(const RowSystem& system, std::span<Joint> joints, Arena& arena);
    int find_shapes(const RowSystem& system, std::span<Joint> joints);
    bool sort(std::span<Joint> joints, int shapes, Arena& arena);
    void place(const RowSystem& system, std::size_t batch);
    // Of the batches that are not followed.
    template <typename Aim>
    void fill(const RowSystem& system, const Aim& aim);
    void take_facts(const RowSystem& system, std::size_t batch, JointRows& from);
    void describe_rows(std::span<Row> rows) const;
    void fill_lane(const RowSystem& system, const RowBlock& block, const Source& source, L* n, int lane,
                   const JointLayout& at, RowForm form) const;
    void visit_lanes(const JointBatch& batch, const bool* lanes, L* n, int world, std::span<Velocity> bodies);
    template <typename Visit>
    void for_each_row(Visit&& f) const;

    static constexpr int kShapes = 3 * (kMaxJointRows + 1) * (kMaxJointRows + 1);

    const JointKernels* machine_;
    const JointKernelsOf<L>* kernels_;
    std::span<JointBatch> batches_;
    std::span<Source> sources_;  // lane by lane
    std::span<L> numbers_, facts_;
    Shape shapes_[kShapes];
    int colours_ = 0;
};

using JointSet = JointSetOf<Lanes>;
using FloatJointSet = JointSetOf<FloatLanes>;

template <>
void FloatJointSet::apply_impulses(std::span<FloatVelocity> bodies) const;
template <>
void FloatJointSet::sweep(std::span<FloatVelocity> bodies, const JointSweep& how);

}  // namespace epode
