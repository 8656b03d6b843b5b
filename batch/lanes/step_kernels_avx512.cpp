// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step of a group compiled for AVX-512: 64-byte registers, nothing fused. See kernels.inc.
#if defined(__x86_64__)
#define EPODE_VECTOR_BYTES 64
#include "batch/lanes/kernels.inc"

namespace epode::batch {

extern const Kernels<float> kAvx512FloatKernels;
constinit const Kernels<float> kAvx512FloatKernels = kernels_of<float>();
extern const Kernels<double> kAvx512DoubleKernels;
constinit const Kernels<double> kAvx512DoubleKernels = kernels_of<double>();

}  // namespace epode::batch
#endif
