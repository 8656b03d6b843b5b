// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact kernels compiled for AVX-512, eight lanes to a vector, as simd/vectors.h tells.
#if defined(__x86_64__)
#define EPODE_VECTOR_LANES 8
#include "solve/contact_kernels.inc"

namespace epode {

extern const ContactKernels kAvx512ContactKernels;
const ContactKernels kAvx512ContactKernels{
    "avx512",
    {prepare<Lanes>, apply_impulses<Lanes>, sweep<Lanes>},
    {prepare<BroadLanes>, apply_impulses<BroadLanes>, sweep<BroadLanes>},
    normal_velocities,
    round_velocities,
    add_changes};

}  // namespace epode
#endif
