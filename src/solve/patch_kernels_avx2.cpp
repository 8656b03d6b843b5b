// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The patch kernels compiled for AVX2, without fused multiply-add, which would round differently.
#if defined(__x86_64__)
#include "solve/patch_kernels.inc"

namespace epode {

extern const PatchKernels kAvx2PatchKernels;
const PatchKernels kAvx2PatchKernels{"avx2",  prepare_patches, apply_patches, correct,    relax,
                                     rebound, load_speeds,     take_changes,  accelerate, move};

}  // namespace epode
#endif
