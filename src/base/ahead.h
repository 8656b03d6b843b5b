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

// Starts to bring the first kLines lines of the cache at p, which may be no pointer to anything.
template <int kLines>
void fetch(const void* p)
{
    const auto at = reinterpret_cast<std::uintptr_t>(p);
    for (int i = 0; i < kLines; ++i)
        __builtin_prefetch(reinterpret_cast<const void*>(at + std::uintptr_t(i) * kCacheLine));
}

// f(i, object i) one after the other, each fetched kLines lines far in time.
template <int kLines, typename T, typename F>
void for_each_fetched(std::span<T* const> objects, F&& f)
{
    constexpr std::size_t kAhead = 6;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (i + kAhead < objects.size()) fetch<kLines>(objects[i + kAhead]);
        f(i, *objects[i]);
    }
}

// f(object) down a list by `next`, which f may not change. Objects of a list have as a rule been made one
// after the other, at equal distances in memory: the next but three is likely to be where the last step,
// taken four times, leads. Where it is not, nothing is lost. Of kLines, so many lie before the object's
// address.
template <int kLines, int kLinesBefore = 0, typename T, typename F>
void for_each_linked(T* first, F&& f)
{
    for (T* object = first; object;) {
        T* const next = object->next;
        const auto here = reinterpret_cast<std::uintptr_t>(object),
                   there = reinterpret_cast<std::uintptr_t>(next);
        const std::uintptr_t before = kLinesBefore * kCacheLine;
        if (next) fetch<kLines>(reinterpret_cast<const void*>(there + 7 * (there - here) - before));
        f(*object);
        object = next;
    }
}

}  // namespace epode
