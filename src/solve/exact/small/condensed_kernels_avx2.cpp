// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The condensed solve compiled for AVX2: registers of four and of two doubles. CMake gives this file its flags; on
// other machines it is empty.
#if defined(__x86_64__)
#include "solve/exact/small/condensed.inc"

namespace epode {

extern const CondensedKernels kAvx2CondensedKernels;
constinit const CondensedKernels kAvx2CondensedKernels = kernels_named("avx2");

}  // namespace epode
#endif
