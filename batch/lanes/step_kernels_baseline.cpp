// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step of a group compiled for every machine: 16-byte registers. See kernels.inc.

#include "batch/lanes/kernels.inc"

namespace epode::batch {

extern const Kernels<float> kBaselineFloatKernels;
constinit const Kernels<float> kBaselineFloatKernels = kernels_of<float>();
extern const Kernels<double> kBaselineDoubleKernels;
constinit const Kernels<double> kBaselineDoubleKernels = kernels_of<double>();

}  // namespace epode::batch
