// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The body kernels for any machine, and the choice among the available sets. It is made when the library is
// loaded, so that calls go through one pointer without a test.
#include "simd/machine.h"
#include "solve/substeps/body_kernels.inc"

namespace epode {

extern const BodyKernels kAvx2BodyKernels, kAvx512BodyKernels;

namespace {

constexpr BodyKernels kBaseline = kernels_named("baseline");

constexpr const BodyKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2BodyKernels,
    &kAvx512BodyKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const BodyKernels* const> body_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
