// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint kernels on float lanes, as joint_kernels_avx2.cpp has those on Reals.
#if defined(__x86_64__)
#include "solve/joints/joint_facts.inc"
#include "solve/joints/joint_kernels.inc"

namespace epode {

extern const FloatJointKernels kAvx2FloatJointKernels;
constinit const FloatJointKernels kAvx2FloatJointKernels{kKernels<FloatLanes>,
                                                         kSweeps<FloatLanes, FloatVelocity>};

}  // namespace epode
#endif
