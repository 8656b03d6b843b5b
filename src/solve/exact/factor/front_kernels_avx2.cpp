// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The front kernels compiled for AVX2: 32-byte registers, no fused multiply-add, which would round
// differently. CMake gives this file its flag; on other machines it is empty.
#if defined(__x86_64__)
#include "solve/exact/factor/front_kernels.inc"

namespace epode {

extern const FrontKernels kAvx2FrontKernels;
constinit const FrontKernels kAvx2FrontKernels = kernels_named("avx2");

}  // namespace epode
#endif
