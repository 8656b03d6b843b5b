// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which of the texts that are compiled for several machines this one can run. Asked when the library is
// loaded, so that calls go through one pointer and no test. EPODE_KERNELS=baseline in the environment keeps
// to what runs anywhere: the bits are the same, which is what it is there to show.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace epode {

inline bool wants_baseline()
{
    const char* kernels = std::getenv("EPODE_KERNELS");
    return kernels && std::strcmp(kernels, "baseline") == 0;
}

// Of `all` kernels, the first of which runs anywhere and the others want AVX2.
inline std::size_t usable_kernels(std::size_t all)
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && !wants_baseline() ? all : 1;
#else
    return wants_baseline() ? 1 : all;
#endif
}

}  // namespace epode
