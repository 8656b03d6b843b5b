// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The patch kernels compiled for AVX-512, eight lanes to a vector, as simd/vectors.h tells.
#if defined(__x86_64__)
#define EPODE_VECTOR_LANES 8
#include "solve/substeps/patch_kernels.inc"

namespace epode {

extern const PatchKernels kAvx512PatchKernels;
constinit const PatchKernels kAvx512PatchKernels = kernels_named("avx512");

}  // namespace epode
#endif
