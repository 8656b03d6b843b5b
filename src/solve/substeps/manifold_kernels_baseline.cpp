// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The manifold kernels for any machine, and the choice among the available sets, made when the library is
// loaded.
#include "simd/machine.h"
#include "solve/substeps/manifold_kernels.inc"

namespace epode {

extern const ManifoldKernels kAvx2ManifoldKernels, kAvx512ManifoldKernels;

namespace {

constexpr ManifoldKernels kBaseline = kernels_named("baseline");

constexpr const ManifoldKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2ManifoldKernels,
    &kAvx512ManifoldKernels,
#endif
};

const std::size_t usable = usable_kernels();

}  // namespace

std::span<const ManifoldKernels* const> manifold_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
