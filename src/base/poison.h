// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tells the address sanitizer which parts of the library's own pools and arenas are unused. It knows this of
// malloc but not of them, and without it would miss uses of destroyed objects and of memory of earlier steps.
// Without the sanitizer both functions are empty.
#pragma once

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#define EPODE_POISONS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define EPODE_POISONS 1
#endif
#endif

#if defined(EPODE_POISONS)
#include <sanitizer/asan_interface.h>
#endif

namespace epode {

// No access until unpoison(). Both take whole granules of 8 bytes inside the range.
inline void poison([[maybe_unused]] void* from, [[maybe_unused]] std::size_t size)
{
#if defined(EPODE_POISONS)
    __asan_poison_memory_region(from, size);
#endif
}

inline void unpoison([[maybe_unused]] void* from, [[maybe_unused]] std::size_t size)
{
#if defined(EPODE_POISONS)
    __asan_unpoison_memory_region(from, size);
#endif
}

}  // namespace epode
