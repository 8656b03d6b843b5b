// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint kernels compiled for AVX-512, eight lanes per vector (simd/pack.h).
#if defined(__x86_64__)
#define EPODE_VECTOR_BYTES 64
#include "solve/joints/joint_facts.inc"
#include "solve/joints/joint_kernels.inc"

namespace epode {

extern const FloatJointKernels kAvx512FloatJointKernels;
extern const JointKernels kAvx512JointKernels;
constinit const JointKernels kAvx512JointKernels{"avx512", kKernels<Lanes>, &kAvx512FloatJointKernels};

}  // namespace epode
#endif
