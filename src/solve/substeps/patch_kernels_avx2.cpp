// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The patch kernels compiled for AVX2, without fused multiply-add, which would round differently.
#if defined(__x86_64__)
#include "solve/substeps/patch_kernels.inc"

namespace epode {

extern const PatchKernels kAvx2PatchKernels;
constinit const PatchKernels kAvx2PatchKernels = kernels_named("avx2");

}  // namespace epode
#endif
