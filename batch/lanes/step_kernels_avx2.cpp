// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step of a group compiled for AVX2: 32-byte registers, nothing fused. See kernels.inc.
#if defined(__x86_64__)

#include "batch/lanes/kernels.inc"

namespace epode::batch {

extern const Kernels<float> kAvx2FloatKernels;
constinit const Kernels<float> kAvx2FloatKernels = kernels_of<float>();
extern const Kernels<double> kAvx2DoubleKernels;
constinit const Kernels<double> kAvx2DoubleKernels = kernels_of<double>();

}  // namespace epode::batch
#endif
