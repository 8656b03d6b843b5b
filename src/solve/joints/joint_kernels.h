// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The operations on packed joints, once per kind of machine, with the same bits as result; the processor is
// queried as in contact_kernels.h. Plain pointers and counts for the reason given there.
#pragma once

#include <span>

#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/joints/joint_batch.h"

namespace epode {

struct JointSweep {
    Real w;      // over-relaxation
    bool relax;  // target `relaxed` instead of c
};

// The rows of the joints of a batch at the beginning of a step, lane by lane; zeros where there is no joint.
struct JointRows {
    const Row* row[kMaxJointRows][kLanes];  // by their place in the batch
    const RowBlock* block[kLanes];
    const SolverPose* poses;
    const Velocity* bodies;
    Substep step;
};

// L: Lanes or FloatLanes.
template <typename L>
struct JointBeginOf {
    L* facts;                 // only for batches that are followed
    const SolverPose* poses;  // likewise
    bool turn;                // the first stage of what is followed; else the second, and all of the others
    Real soft_share;          // above zero: rows with C above this share of 1 / effective mass relax to c
};

// `at` of the batches counts from `numbers`. B: Velocity or FloatVelocity.
template <typename L, typename B>
struct JointSweepsOf {
    // v += M^-1 J^T p
    void (*apply_impulses)(const JointBatch* batches, int count, const L* numbers, B* bodies);
    void (*sweep)(const JointBatch* batches, int count, L* numbers, B* bodies, const JointSweep& how);
};

template <typename L>
struct JointKernelsOf {
    // Facts of a batch, masses and C, except which rows keep their target and when the matrix was made.
    void (*take_facts)(const JointBatch& batch, L* numbers, L* facts, const JointRows& from);
    // From masses, geometry, C, p and bounds, the matrix and p within its bounds. Of batches with facts in two
    // stages: before that, masses and geometry from poses; and c and the relaxing target.
    void (*begin)(const JointBatch* batches, int count, L* numbers, const JointBeginOf<L>& how);
    // For FloatLanes: velocities are rounded when they are read, and their changes are added.
    JointSweepsOf<L, Velocity> on_velocities;
};

// Compiled in files of their own, which halves the time of the slowest file.
struct FloatJointKernels {
    JointKernelsOf<FloatLanes> all;
    JointSweepsOf<FloatLanes, FloatVelocity> on_floats;
};

struct JointKernels {
    const char* name;
    JointKernelsOf<Lanes> reals;
    const FloatJointKernels* floats;

    const JointKernelsOf<Lanes>& of(const Lanes*) const { return reals; }
    const JointKernelsOf<FloatLanes>& of(const FloatLanes*) const { return floats->all; }
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const JointKernels* const> joint_kernels();

}  // namespace epode
