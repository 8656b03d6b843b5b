// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The row kernels for any machine, and the choice among the available sets, made when the library is loaded.
#include "simd/machine.h"
#include "solve/exact/problem/row_kernels.inc"

namespace epode {

extern const RowKernels kAvx2RowKernels, kAvx512RowKernels;

namespace {

constexpr RowKernels kBaseline = kernels_named("baseline");

constexpr const RowKernels* kAll[] = {
    &kBaseline,
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    &kAvx2RowKernels,
    &kAvx512RowKernels,
#endif
};

const int usable = int(usable_kernels());

}  // namespace

int count_row_kernels() { return usable; }
const RowKernels& row_kernels(int i) { return *kAll[i]; }
const RowKernels& row_kernels() { return *kAll[usable - 1]; }

}  // namespace epode
