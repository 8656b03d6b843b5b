// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is done to packed manifolds, once per kind of machine (see contact_kernels.h), with the same
// bits as result.
#pragma once

#include <span>

#include "rows/row_system.h"
#include "solve/common/velocities.h"
#include "solve/substeps/manifold_batch.h"

namespace epode {

// What a sweep needs besides the batches.
struct ManifoldSweep {
    float per_hs;             // 1 / hs
    float max_bias_velocity;  // largest velocity that takes depth away
};

// Bodies as sweeps see them: what they do to the floats becomes a change of the doubles, so that a body that
// nobody pushes keeps its velocity to the last bit.
struct ManifoldBodies {
    Velocity* v;
    Velocity* impulse_velocity;      // what the impulses at hand do: M^-1 J^T p
    const Velocity* force_velocity;  // by forces, in one substep
    Velocity* mean;                  // sum over the substeps
    FloatMotion* motions;
    float hs;
};

// What the lanes of a batch are made of. A lane that is not needed has a manifold without points; who does not
// move, a body without mass.
struct ManifoldSources {
    const ContactManifold* manifolds[kBroadLanes];
    const SolverBody *body1[kBroadLanes], *body2[kBroadLanes];
};

// Of what is too deep (ManifoldBatch): if both bodies move, if one does.
struct ManifoldSprings {
    float bias_rate[2], mass_scale[2];
};

struct ManifoldKernels {
    const char* name;
    // Out: masses, material, n, drift, rate and soft of the batch, and of its points what `prepare` takes.
    void (*gather)(ManifoldBatch& batch, ManifoldLanes* points, const ManifoldSources& from,
                   const ManifoldSprings& springs);
    // In: arms, normal, drift, p along n and `sum` as a vector of the world. Out: all but separation, or where there
    // is one, batch.friction.
    void (*prepare)(ManifoldBatch& batch, ManifoldLanes* points, const FloatMotion* motions, float share);
    // v += M^-1 J^T p of the batches first ... last - 1.
    void (*apply_impulses)(const ManifoldBatch* batches, int first, int last, const ManifoldLanes* points,
                           FloatMotion* motions);
    void (*correct)(const ManifoldBatch* batches, int first, int last, ManifoldLanes* points,
                    FloatMotion* motions, const ManifoldSweep& sweep);
    void (*relax)(const ManifoldBatch* batches, int first, int last, ManifoldLanes* points,
                  FloatMotion* motions);
    // Into along1 and along2: what of the sum of batch.friction is its points' part (contact_friction.inc).
    void (*share_friction)(const ManifoldBatch& batch, BroadLanes* along1, BroadLanes* along2);
    // What came in fast and was pushed leaves with its rebound.
    void (*apply_restitution)(const ManifoldBatch* batches, int first, int last, ManifoldLanes* points,
                              FloatMotion* motions);
    // Of the bodies first ... last - 1: velocities to floats, and what sweeps have changed back.
    void (*load_velocities)(const ManifoldBodies& bodies, int first, int last);
    void (*take_changes)(const ManifoldBodies& bodies, int first, int last);
    // Before the first sweep of a substep: v += gain + kicks; between correcting and relaxing: the change
    // taken, then the bodies move for hs. Both leave v in the floats.
    void (*accelerate)(const ManifoldBodies& bodies, int first, int last);
    void (*move)(const ManifoldBodies& bodies, int first, int last);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const ManifoldKernels* const> manifold_kernels();

}  // namespace epode
