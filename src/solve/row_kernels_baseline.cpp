// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The row kernels for any machine, and the choice between those that there are, made when the library is
// loaded.
#include "solve/row_kernels.inc"

namespace epode {

extern const RowKernels kAvx2RowKernels;

namespace {

constexpr RowKernels kBaseline{"baseline", products, add_transposed, assemble, advance, aim, centre, finish};

#if defined(__x86_64__)
constexpr const RowKernels* kAll[] = {&kBaseline, &kAvx2RowKernels};

int count_usable()
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") ? 2 : 1;
}

const int usable = count_usable();
#else
constexpr const RowKernels* kAll[] = {&kBaseline};
constexpr int usable = 1;
#endif

}  // namespace

int count_row_kernels() { return usable; }
const RowKernels& row_kernels(int i) { return *kAll[i]; }
const RowKernels& row_kernels() { return *kAll[usable - 1]; }

}  // namespace epode
