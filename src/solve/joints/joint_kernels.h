// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is done to packed joints, once per kind of machine, with the same bits as result; chosen as
// contact_kernels.h tells. Plain pointers and counts for the reason given there.
#pragma once

#include <span>

#include "solve/common/substep_rows.h"
#include "solve/common/velocities.h"
#include "solve/joints/joint_batch.h"

namespace epode {

struct JointSweep {
    Real w;      // over-relaxation
    bool relax;  // aims at `relaxed` instead of c
};

// What the joints of a batch say at the beginning of a step, lane by lane; where there is no joint, nothing
// but zeros.
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
    L* facts;                 // only of batches that are followed
    const SolverPose* poses;  // likewise
    Real soft_share;          // above zero: rows with C above this share of their inverse_mass relax to c
    Velocity* bodies;         // null: p does nothing yet
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
    // Facts of a batch, masses and C; but not who keeps its aim, nor when the matrix was made.
    void (*take_facts)(const JointBatch& batch, L* numbers, L* facts, const JointRows& from);
    // Batch by batch, while its numbers are near: of those that have facts, masses, geometry, c and what
    // relaxing aims at; then of masses, geometry, C, p and bounds, the matrix, and p within its bounds; then
    // what p does to the bodies.
    void (*begin)(const JointBatch* batches, int count, L* numbers, const JointBeginOf<L>& how);
    // Of FloatLanes: velocities are rounded on their way in, and what has changed is added to them.
    JointSweepsOf<L, Velocity> on_velocities;
};

struct JointKernels {
    const char* name;
    JointKernelsOf<Lanes> reals;
    JointKernelsOf<FloatLanes> floats;
    JointSweepsOf<FloatLanes, FloatVelocity> on_floats;

    const JointKernelsOf<Lanes>& of(const Lanes*) const { return reals; }
    const JointKernelsOf<FloatLanes>& of(const FloatLanes*) const { return floats; }
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const JointKernels* const> joint_kernels();

}  // namespace epode
