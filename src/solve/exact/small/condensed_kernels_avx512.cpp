// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The condensed solve compiled for AVX-512: one register for six doubles. CMake gives this file its flags; on
// other machines it is empty.
#if defined(__x86_64__)
#define EPODE_VECTOR_LANES 8
#include "solve/exact/small/condensed.inc"

namespace epode {

extern const CondensedKernels kAvx512CondensedKernels;
constinit const CondensedKernels kAvx512CondensedKernels = kernels_named("avx512");

}  // namespace epode
#endif
