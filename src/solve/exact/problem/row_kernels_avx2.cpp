// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The row kernels compiled for AVX2: 32-byte registers, no fused multiply-add, which would round differently.
// CMake gives this file its flag; on other machines it is empty.
#if defined(__x86_64__)
#include "solve/exact/problem/row_kernels.inc"

namespace epode {

extern const RowKernels kAvx2RowKernels;
constinit const RowKernels kAvx2RowKernels = kernels_named("avx2");

}  // namespace epode
#endif
