// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The joint kernels on float lanes, as joint_kernels_baseline.cpp has those on Reals.
#include "solve/joints/joint_facts.inc"
#include "solve/joints/joint_kernels.inc"

namespace epode {

extern const FloatJointKernels kBaselineFloatJointKernels;
constinit const FloatJointKernels kBaselineFloatJointKernels{kKernels<FloatLanes>,
                                                             kSweeps<FloatLanes, FloatVelocity>};

}  // namespace epode
