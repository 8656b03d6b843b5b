// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint kernels compiled for AVX2: 32-byte registers, no fused multiply-add, which would round
// differently. CMake gives this file its flag; on other machines it is empty.
#if defined(__x86_64__)
#include "solve/joints/joint_facts.inc"
#include "solve/joints/joint_kernels.inc"

namespace epode {

extern const FloatJointKernels kAvx2FloatJointKernels;
extern const JointKernels kAvx2JointKernels;
constinit const JointKernels kAvx2JointKernels{"avx2", kKernels<Lanes>, &kAvx2FloatJointKernels};

}  // namespace epode
#endif
