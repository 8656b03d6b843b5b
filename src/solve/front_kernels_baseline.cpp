// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The front kernels for any machine, and the choice between those that there are. It is made when the
// library is loaded, so that calls go through one pointer and no test.
#include "solve/front_kernels.inc"

namespace epode {

extern const FrontKernels kAvx2FrontKernels;

namespace {

constexpr FrontKernels kBaseline{"baseline", factor,  factor_columns, subtract_outer,
                                 add_border, forward, backward};

#if defined(__x86_64__)
constexpr const FrontKernels* kAll[] = {&kBaseline, &kAvx2FrontKernels};

std::size_t count_usable()
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") ? 2 : 1;
}

const std::size_t usable = count_usable();
#else
constexpr const FrontKernels* kAll[] = {&kBaseline};
constexpr std::size_t usable = 1;
#endif

}  // namespace

std::span<const FrontKernels* const> front_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
