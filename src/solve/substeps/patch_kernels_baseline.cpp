// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The patch kernels for any machine, and the choice between those that there are, made when the library is
// loaded.
#include "simd/machine.h"
#include "solve/substeps/patch_kernels.inc"

namespace epode {

extern const PatchKernels kAvx2PatchKernels, kAvx512PatchKernels;

namespace {

constexpr PatchKernels kBaseline = kernels_named("baseline");

constexpr const PatchKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__)
    &kAvx2PatchKernels,
    &kAvx512PatchKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const PatchKernels* const> patch_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
