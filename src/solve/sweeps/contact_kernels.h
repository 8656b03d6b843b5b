// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The operations on packed contacts, once per kind of machine: the same text (contact_kernels.inc) compiled
// for the baseline, for AVX2 and for AVX-512, with the same bits as result. The processor is queried for the
// fastest; compiling the whole library for it would exclude machines that lack it.
#pragma once

#include <span>

#include "rows/row_system.h"
#include "solve/common/velocities.h"
#include "solve/sweeps/contact_batch.h"

namespace epode {

// Where the lanes of a batch come from; lanes without a manifold, points or bodies have ones that do nothing.
template <typename L>
struct ContactSourcesOf {
    const JointManifold* manifold[L::kCount];
    const SolverBody *body1[L::kCount], *body2[L::kCount];
    const JointManifoldPoint* point[kManifoldPoints][L::kCount];
};

// Plain pointers and counts: an inline function of a span, compiled for AVX2, could be the copy that the
// linker keeps for everybody. `batch.first` counts from `points`, `order` from `batches`; a single batch
// comes with its own points.
template <typename L>
struct ContactKernelsOf {
    using Bodies = typename VelocityOf<L>::Type;
    // Writes masses, directions and friction targets of the batch; arms, normal and p of the points.
    void (*gather)(ContactBatchOf<L>& batch, BatchPointOf<L>* points, const ContactSourcesOf<L>& from);
    // Couplings and effective masses are computed from the rest, and p is put within its limits.
    void (*prepare)(const ContactBatchOf<L>& batch, BatchPointOf<L>* points, typename L::Number w);
    // v += M^-1 J^T p
    void (*apply_impulses)(const ContactBatchOf<L>* batches, int count, const BatchPointOf<L>* points,
                           Bodies* bodies);
    void (*sweep)(const ContactBatchOf<L>* batches, const int* order, int count, BatchPointOf<L>* points,
                  Bodies* bodies);
    // For a batch with manifold friction: writes each point's part of it to p of the tangents.
    void (*share_friction)(const ContactBatchOf<L>& batch, BatchPointOf<L>* points);
};

struct ContactKernels {
    const char* name;
    ContactKernelsOf<Lanes> reals;
    ContactKernelsOf<BroadLanes> floats;
    // J_n v of the batch's points.
    void (*normal_velocities)(const ContactBatch& batch, const BatchPoint* points, const Velocity* bodies,
                              Lanes* out);
    // Before float sweeps: to = from, rounded. After them: to += what they have changed.
    void (*round_velocities)(const Velocity* from, int count, FloatVelocity* to);
    void (*add_changes)(const FloatVelocity* from, int count, Velocity* to);

    const ContactKernelsOf<Lanes>& of(const Lanes*) const { return reals; }
    const ContactKernelsOf<BroadLanes>& of(const BroadLanes*) const { return floats; }
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const ContactKernels* const> contact_kernels();

}  // namespace epode
