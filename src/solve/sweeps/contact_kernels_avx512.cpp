// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact kernels compiled for AVX-512, eight lanes per vector (simd/pack.h).
#if defined(__x86_64__)
#define EPODE_VECTOR_BYTES 64
#include "solve/sweeps/contact_kernels.inc"

namespace epode {

extern const ContactKernels kAvx512ContactKernels;
constinit const ContactKernels kAvx512ContactKernels = kernels_named("avx512");

}  // namespace epode
#endif
