// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which of the texts that are compiled for several machines this one can run. Asked when the library is
// loaded, so that calls go through one pointer and no test.
#pragma once

#include <cstddef>

namespace epode {

// Of `all` kernels, the first of which runs anywhere and the others want AVX2.
inline std::size_t usable_kernels(std::size_t all)
{
#if defined(__x86_64__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") ? all : 1;
#else
    return all;
#endif
}

}  // namespace epode
