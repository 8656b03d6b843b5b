// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Prefetching. A loop over bodies in the order of their islands jumps through memory, and the processor
// cannot guess where the next body lies. Such a loop prefetches each object a few iterations before it needs
// it. Without this, most of the time of such a loop in a world of thousands of bodies was spent waiting for
// memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/config.h"

namespace epode {

// Prefetches the first kLines cache lines at p, which need not be a valid pointer. The empty asm statement
// keeps the function alive: gcc treats functions that only prefetch as functions without effect, and drops
// calls to them that it has not inlined.
template <int kLines>
inline void prefetch(const void* p)
{
    const auto at = reinterpret_cast<std::uintptr_t>(p);
    for (int i = 0; i < kLines; ++i)
        __builtin_prefetch(reinterpret_cast<const void*>(at + std::uintptr_t(i) * kCacheLine));
    asm volatile("" : : "r"(p));
}

// Calls f(i, object i) for every object and prefetches kLines lines of the object kAhead iterations later.
// The less f does, the larger kAhead should be.
template <int kLines, std::size_t kAhead = 6, typename T, typename F>
void for_each_prefetched(std::span<T* const> objects, F&& f)
{
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (i + kAhead < objects.size()) prefetch<kLines>(objects[i + kAhead]);
        f(i, *objects[i]);
    }
}

}  // namespace epode
