// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The front kernels for any machine, and the choice among the available sets. It is made when the library is
// loaded, so that calls go through one pointer without a test.
#include "simd/machine.h"
#include "solve/exact/factor/front_kernels.inc"

namespace epode {

extern const FrontKernels kAvx2FrontKernels, kAvx512FrontKernels;

namespace {

constexpr FrontKernels kBaseline = kernels_named("baseline");

constexpr const FrontKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2FrontKernels,
    &kAvx512FrontKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const FrontKernels* const> front_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
