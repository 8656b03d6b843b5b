// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contact kernels for any machine, and the choice between those that there are. It is made when the
// library is loaded, so that calls go through one pointer and no test.
#include "solve/contact_kernels.inc"

namespace epode {

extern const ContactKernels kAvx2ContactKernels;

namespace {

constexpr ContactKernels kBaseline{"baseline", prepare, apply_impulses, sweep, normal_velocities};

#if defined(__x86_64__)
constexpr const ContactKernels* kAll[] = {&kBaseline, &kAvx2ContactKernels};

std::size_t count_usable()
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") ? 2 : 1;
}

const std::size_t usable = count_usable();
#else
constexpr const ContactKernels* kAll[] = {&kBaseline};
constexpr std::size_t usable = 1;
#endif

}  // namespace

std::span<const ContactKernels* const> contact_kernels() { return std::span(kAll).first(usable); }

}  // namespace epode
