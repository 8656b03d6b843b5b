// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is done to packed joints, once per kind of machine, with the same bits as result; chosen as
// contact_kernels.h tells. Plain pointers and counts for the reason given there.
#pragma once

#include <span>

#include "solve/joint_batch.h"
#include "solve/velocities.h"

namespace epode {

struct JointSweep {
    Real w;      // over-relaxation
    bool relax;  // aims at `relaxed` instead of c
};

// `at` of the batches counts from `numbers`.
struct JointKernels {
    const char* name;
    // In: masses, geometry, C, p and bounds. Out: the matrix, and p within its bounds. With a `soft_share`,
    // rows with C above this share of their mobility relax to c.
    void (*prepare)(const JointBatch* batches, int count, Lanes* numbers, Real soft_share);
    // In: facts of batches that have any, and poses. Out: masses, geometry, c and what relaxing aims at.
    void (*follow)(const JointBatch* batches, int count, Lanes* numbers, const Lanes* facts,
                   const SolverPose* poses);
    // v += M^-1 J^T p
    void (*apply_impulses)(const JointBatch* batches, int count, const Lanes* numbers, Velocity* bodies);
    void (*sweep)(const JointBatch* batches, int count, Lanes* numbers, Velocity* bodies,
                  const JointSweep& how);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const JointKernels* const> joint_kernels();

}  // namespace epode
