// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Going through objects that lie about in memory, in an order of their own (bodies in the order of their
// islands): the processor cannot guess where the next one is, so it is told a few objects before it is
// needed. In a world of thousands of bodies, most of the time of such a loop was waiting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/config.h"

namespace epode {

// Starts to bring the first kLines lines of the cache at p, which may be no pointer to anything. The empty
// statement keeps it alive: gcc takes functions that do nothing but this for functions without effect, and
// leaves calls of them out where it has not put them in line before.
template <int kLines>
inline void prefetch(const void* p)
{
    const auto at = reinterpret_cast<std::uintptr_t>(p);
    for (int i = 0; i < kLines; ++i)
        __builtin_prefetch(reinterpret_cast<const void*>(at + std::uintptr_t(i) * kCacheLine));
    asm volatile("" : : "r"(p));
}

// f(i, object i) one after the other, each fetched kLines lines far in time: the farther, the less f does.
template <int kLines, std::size_t kAhead = 6, typename T, typename F>
void for_each_prefetched(std::span<T* const> objects, F&& f)
{
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (i + kAhead < objects.size()) prefetch<kLines>(objects[i + kAhead]);
        f(i, *objects[i]);
    }
}

}  // namespace epode
