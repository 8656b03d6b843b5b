// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The row kernels compiled for AVX-512, eight lanes per vector (simd/pack.h).
#if defined(__x86_64__)
#define EPODE_VECTOR_LANES 8
#include "solve/exact/problem/row_kernels.inc"

namespace epode {

extern const RowKernels kAvx512RowKernels;
constinit const RowKernels kAvx512RowKernels = kernels_named("avx512");

}  // namespace epode
#endif
