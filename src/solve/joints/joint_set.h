// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints packed for sweeping (solve/joints/joint_batch.h) and the operations on all of them. Graph colouring:
// joints of one colour share no dynamic body. Each gets the smallest colour that its bodies have free, in the
// order of the joints. Joints of one colour and one shape of rows form batches of up to eight. Sweeps go
// colour by colour, always in the same direction: alternating directions, as symmetric SOR does, made a
// hanging net separate twice as far. Since colours depend on the neighbours alone, an island has the same
// answer whether it is packed alone or with others. solve/joints/joint_lanes.h decides which joints are
// packed in floats.
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

    // Packs these blocks, none of which are contacts, with bounds and warm start from the numbers; false: out
    // of memory.
    bool pack(const RowSystem& system, std::span<const int> blocks, Arena& arena);
    void load(const RowSystem& system);  // targets from the numbers
    // Alternative for substeps. follow, once, computes from rows, poses and velocities at the beginning the
    // facts of all blocks that the kernels follow (solve/joints/joint_follow.inc) and marks these blocks;
    // false: out of memory. turn, whenever poses have changed, brings the geometry of followed rows there, but
    // not yet their targets: springs relax to those that they had. load_substep brings these, too, and reads
    // the others.
    bool follow(const RowSystem& system, const Substep& step, std::span<const Velocity> bodies, Arena& arena);
    void turn(const RowSystem& system);
    void load_substep(const RowSystem& system, const Substep& step);

    void apply_impulses(std::span<Velocity> bodies) const;  // v += M^-1 J^T p
    void sweep(std::span<Velocity> bodies, const JointSweep& how);
    // For FloatLanes, the same on velocities that are rounded already.
    void apply_impulses(std::span<FloatVelocity> bodies) const;
    void sweep(std::span<FloatVelocity> bodies, const JointSweep& how);
    void store_impulses(std::span<RowNumbers> numbers) const;
    void sum_impulses();  // sum += p, after each substep
    void store_sums(std::span<RowNumbers> numbers) const;
    // c, C and p of the correcting problem, and the Jacobians of followed rows.
    void describe(std::span<RowNumbers> numbers, std::span<Row> rows) const;

    // Restitution: one more visit to joints whose rows have restitution and carried an impulse; they reach
    // their restitution velocity.
    void apply_restitution(const RowSystem& system, std::span<Velocity> bodies);

    bool empty() const { return batches_.empty(); }

  private:
    using Number = typename L::Number;

    // Which joint is in a lane, and where its rows are: free rows come first.
    struct Source {
        int block;  // -1: none
        int first;  // row of the system
        unsigned char row[kMaxBlockRows];
        char filled_up[9];  // to a power of two
    };
    static_assert(sizeof(Source) == 32);
    struct Shape {
        RowForm form;
        int rows, bounded;
        bool operator==(const Shape&) const = default;
    };
    // A joint during sorting.
    struct Joint {
        int block, colour, shape;
    };

    static Shape shape_of(const RowSystem& system, const RowBlock& block);
    void colour(const RowSystem& system, std::span<Joint> joints, Arena& arena);
    int find_shapes(const RowSystem& system, std::span<Joint> joints);
    bool sort(std::span<Joint> joints, int shapes, Arena& arena);
    void place(const RowSystem& system, std::size_t batch);
    // For the batches that are not followed.
    template <typename Aim>
    void fill(const RowSystem& system, const Aim& aim);
    void take_facts(const RowSystem& system, std::size_t batch, JointRows& from);
    void describe_rows(std::span<Row> rows) const;
    void fill_lane(const RowSystem& system, const RowBlock& block, const Source& source, L* n, int lane,
                   const JointLayout& at, RowForm form) const;
    void visit_lanes(const JointBatch& batch, const bool* lanes, L* n, int world, std::span<Velocity> bodies);
    template <typename Visit>
    void for_each_row(Visit&& f) const;

    // Forms other than the free one have at most kMaxJointRows rows.
    static constexpr int kShapes =
        2 * (kMaxJointRows + 1) * (kMaxJointRows + 1) + (kMaxBlockRows + 1) * (kMaxBlockRows + 1);

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
