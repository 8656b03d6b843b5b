// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is done to packed patches, once per kind of machine (see contact_kernels.h): the baseline and AVX2,
// with the same bits as result.
#pragma once

#include <span>

#include "solve/patch_batch.h"

namespace epode {

// What a sweep needs besides the batches.
struct PatchSweep {
    float per_step;  // 1 / hs
    float push_out;  // largest velocity that takes depth away
};

struct PatchKernels {
    const char* name;
    // In: arms, normal, drift, p along n and `sum` as a vector of the world. Out: all but gap.
    void (*prepare)(PatchBatch& batch, PatchLanes* points, const FloatMotion* motions, float share);
    // v += M^-1 J^T p of the batches first ... last - 1.
    void (*apply_impulses)(const PatchBatch* batches, int first, int last, const PatchLanes* points,
                           FloatMotion* motions);
    void (*correct)(const PatchBatch* batches, int first, int last, PatchLanes* points, FloatMotion* motions,
                    const PatchSweep& sweep);
    void (*relax)(const PatchBatch* batches, int first, int last, PatchLanes* points, FloatMotion* motions);
    // What came in fast and was pushed leaves with its rebound.
    void (*rebound)(const PatchBatch* batches, int first, int last, PatchLanes* points, FloatMotion* motions);
};

// Those that this machine can run; the first is the baseline, the last the fastest.
std::span<const PatchKernels* const> patch_kernels();

}  // namespace epode
