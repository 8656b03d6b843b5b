// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The patch kernels for any machine, and the choice between those that there are, made when the library is
// loaded.
#include "solve/patch_kernels.inc"

namespace epode {

extern const PatchKernels kAvx2PatchKernels;

namespace {

constexpr PatchKernels kBaseline{"baseline", prepare_patches, apply_patches, correct, relax, rebound};

#if defined(__x86_64__)
constexpr const PatchKernels* kAll[] = {&kBaseline, &kAvx2PatchKernels};

std::size_t count_usable()
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") ? 2 : 1;
}

const std::size_t usable = count_usable();
#else
constexpr const PatchKernels* kAll[] = {&kBaseline};
constexpr std::size_t usable = 1;
#endif

}  // namespace

std::span<const PatchKernels* const> patch_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
