// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The choice among the sets of kernels that the library has (kernel_set.cpp.in). It is made when the library is loaded, so that calls go
// through one pointer without a test.
#pragma once

#include <span>

#include "simd/machine.h"

#if defined(__x86_64__) && !defined(EPODE_BASELINE)
#define EPODE_BETTER_KERNELS(Kernels) , &kAvx2##Kernels, &kAvx512##Kernels
#else
#define EPODE_BETTER_KERNELS(Kernels)
#endif

// Defines std::span<const Kernels* const> function(): those that this machine can run; the first is the baseline, the last the fastest.
#define EPODE_CHOOSE_KERNELS(Kernels, function)                                            \
    namespace epode {                                                                      \
    extern const Kernels kAvx2##Kernels, kAvx512##Kernels;                                 \
    namespace {                                                                            \
    constexpr const Kernels* kAll[] = {&kBaseline##Kernels EPODE_BETTER_KERNELS(Kernels)}; \
    const std::size_t usable = usable_kernels();                                           \
    }                                                                                      \
    std::span<const Kernels* const> function() { return std::span(kAll).first(usable); }   \
    }
