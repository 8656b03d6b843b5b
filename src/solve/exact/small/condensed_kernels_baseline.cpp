// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The condensed solve for every machine, and which of them is used.
#include "simd/machine.h"
#include "solve/exact/small/condensed.inc"

namespace epode {

extern const CondensedKernels kAvx2CondensedKernels, kAvx512CondensedKernels;

namespace {

constexpr CondensedKernels kBaseline = kernels_named("baseline");

constexpr const CondensedKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2CondensedKernels,
    &kAvx512CondensedKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const CondensedKernels* const> condensed_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
