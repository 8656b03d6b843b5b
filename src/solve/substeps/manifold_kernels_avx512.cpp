// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The manifold kernels compiled for AVX-512, eight lanes per vector (simd/pack.h).
#if defined(__x86_64__)
#define EPODE_VECTOR_BYTES 64
#include "solve/substeps/manifold_kernels.inc"

namespace epode {

extern const ManifoldKernels kAvx512ManifoldKernels;
constinit const ManifoldKernels kAvx512ManifoldKernels = kernels_named("avx512");

}  // namespace epode
#endif
