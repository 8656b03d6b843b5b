// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The operations on packed contact manifolds, once per kind of machine (see contact_kernels.h), with the same
// bits as result.
#pragma once

#include <span>

#include "rows/row_system.h"
#include "solve/common/velocities.h"
#include "solve/substeps/manifold_batch.h"

namespace epode {

// What a sweep needs in addition to the batches.
struct ManifoldSweep {
    float per_hs;             // 1 / hs
    float max_bias_velocity;  // largest velocity that removes penetration
    float swift;              // approach above which a manifold is worth more sweeps over its normal rows
    float just_closed;        // gap that counts as none after the motion
};

// Bodies as sweeps see them. What sweeps do to the floats becomes a change of the doubles, so that a body
// without impulses keeps its velocity to the last bit.
struct ManifoldBodies {
    Velocity* v;
    Velocity* impulse_velocity;      // effect of the present impulses: M^-1 J^T p
    const Velocity* force_velocity;  // effect of forces in one substep
    Velocity* mean;                  // sum over the substeps
    FloatMotion* motions;
    float hs;
};

// Where the lanes of a batch come from. An unused lane has a manifold without points; a static body is one
// without mass.
struct ManifoldSources {
    const ContactManifold* manifolds[kBroadLanes];
    const SolverBody *body1[kBroadLanes], *body2[kBroadLanes];
};

// Soft constraint of penetrating points (ManifoldBatch): if both bodies move, if one does.
struct ManifoldSprings {
    float bias_rate[2], softness[2];
};

struct ManifoldKernels {
    const char* name;
    // Writes masses, material, n, surface velocity, bias_rate and softness of the batch, and what `prepare`
    // reads of its points.
    void (*gather)(ManifoldBatch& batch, ManifoldLanes* points, const ManifoldSources& from,
                   const ManifoldSprings& springs);
    // Reads arms, normal, surface velocity, p along n and `sum` as a vector of the world. Writes everything
    // but the separation; with manifold friction, batch.friction.
    void (*prepare)(ManifoldBatch& batch, ManifoldLanes* points, const FloatMotion* motions, float share);
    // v += M^-1 J^T p for the batches first ... last - 1.
    void (*apply_impulses)(const ManifoldBatch* batches, int first, int last, const ManifoldLanes* points,
                           FloatMotion* motions);
    void (*correct)(const ManifoldBatch* batches, int first, int last, ManifoldLanes* points,
                    FloatMotion* motions, const ManifoldSweep& sweep);
    void (*relax)(const ManifoldBatch* batches, int first, int last, ManifoldLanes* points,
                  FloatMotion* motions, const ManifoldSweep& sweep);
    // Writes to along1 and along2 each point's part of the sum of batch.friction (contact_friction.inc).
    void (*share_friction)(const ManifoldBatch& batch, BroadLanes* along1, BroadLanes* along2);
    // Above 0 in the lanes that a blow has struck (manifold_math.inc). `motions`: at the end.
    void (*find_blows)(const ManifoldBatch& batch, const ManifoldLanes* points, FloatMotion* motions,
                       BroadLanes& struck);
    // For the bodies first ... last - 1: velocities to floats, and the changes of sweeps back.
    void (*load_velocities)(const ManifoldBodies& bodies, int first, int last);
    void (*take_changes)(const ManifoldBodies& bodies, int first, int last);
    // accelerate, before the first sweep of a substep: v += force_velocity + impulse_velocity. move, between
    // correcting and relaxing: takes the change over, then moves the bodies for hs. Both leave v in the
    // floats.
    void (*accelerate)(const ManifoldBodies& bodies, int first, int last);
    void (*move)(const ManifoldBodies& bodies, int first, int last);
};

// The kernels that this machine can run; the first is the baseline, the last the fastest.
std::span<const ManifoldKernels* const> manifold_kernels();

}  // namespace epode
