// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact kernels compiled for AVX2, that is with 32-byte registers and without fused multiply-add, which
// would round differently. CMake gives this file its flag; on other machines it is empty.
#if defined(__x86_64__)
#include "solve/contact_kernels.inc"

namespace epode {

extern const ContactKernels kAvx2ContactKernels;
const ContactKernels kAvx2ContactKernels{"avx2",
                                         {prepare<Lanes>, apply_impulses<Lanes>, sweep<Lanes>},
                                         {prepare<BroadLanes>, apply_impulses<BroadLanes>, sweep<BroadLanes>},
                                         normal_velocities,
                                         round_velocities,
                                         add_changes};

}  // namespace epode
#endif
