// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint kernels for any machine, and the choice among the available sets. It is made when the library is
// loaded, so that calls go through one pointer without a test.
#include "simd/machine.h"
#include "solve/joints/joint_facts.inc"
#include "solve/joints/joint_kernels.inc"

namespace epode {

extern const JointKernels kAvx2JointKernels, kAvx512JointKernels;
extern const FloatJointKernels kBaselineFloatJointKernels;

namespace {

constexpr JointKernels kBaseline{"baseline", kKernels<Lanes>, &kBaselineFloatJointKernels};

constexpr const JointKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2JointKernels,
    &kAvx512JointKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const JointKernels* const> joint_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
