// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The compiler's library queries the processor and whether the operating system saves such registers (XCR0).
// AVX-512 here means what every x86-64-v4 processor has. In a build with EPODE_LOWERED_AVX512 those kernels
// are compiled to AVX2 instructions, so that their arithmetic can be tested on any machine.
#include "simd/machine.h"

#include <cstring>
#include "base/environment.h"

#include "ode/error.h"

namespace epode {
namespace {

constexpr const char* kNames[] = {"baseline", "avx2", "avx512"};

std::size_t runnable_kernels()
{
#if defined(__x86_64__) && !defined(EPODE_BASELINE)
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return 1;
#if defined(EPODE_LOWERED_AVX512)
    return 3;
#else
    const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd");
    return v4 ? 3 : 2;
#endif
#else
    return 1;
#endif
}

std::size_t chosen_kernels()
{
    const std::size_t all = runnable_kernels();
    const char* wanted = environment_value("EPODE_KERNELS");
    if (!wanted || std::strcmp(wanted, "best") == 0) return all;
    for (std::size_t i = 0; i < all; ++i)
        if (std::strcmp(wanted, kNames[i]) == 0) return i + 1;
    dMessage(0, "EPODE_KERNELS=%s: no such kernels run here; using %s", wanted, kNames[all - 1]);
    return all;
}

}  // namespace

std::size_t usable_kernels()
{
    static const std::size_t chosen = chosen_kernels();
    return chosen;
}

}  // namespace epode
