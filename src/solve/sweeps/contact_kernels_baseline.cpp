// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact kernels for any machine, and the choice among the available sets. It is made when the library
// is loaded, so that calls go through one pointer without a test.
#include "simd/machine.h"
#include "solve/sweeps/contact_kernels.inc"

namespace epode {

extern const ContactKernels kAvx2ContactKernels, kAvx512ContactKernels;

namespace {

constexpr ContactKernels kBaseline = kernels_named("baseline");

constexpr const ContactKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2ContactKernels,
    &kAvx512ContactKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const ContactKernels* const> contact_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
