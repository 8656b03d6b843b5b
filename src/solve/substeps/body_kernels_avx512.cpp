// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The body kernels compiled for AVX-512, eight lanes per vector (simd/pack.h).
#if defined(__x86_64__)
#define EPODE_VECTOR_BYTES 64
#include "solve/substeps/body_kernels.inc"

namespace epode {

extern const BodyKernels kAvx512BodyKernels;
constinit const BodyKernels kAvx512BodyKernels = kernels_named("avx512");

}  // namespace epode
#endif
