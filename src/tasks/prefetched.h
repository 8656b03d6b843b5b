// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#pragma once

#include "base/prefetch.h"
#include "tasks/tasks.h"

namespace epode {

inline constexpr int kObjectRange = 256;  // objects in one piece of work; a multiple of all lanes

// for_each_prefetched() (base/prefetch.h) on all workers. f(i, object i) must not change anything that
// another call reads.
template <int kLines, typename T, typename F>
void for_each_prefetched(const Tasks& tasks, std::span<T* const> objects, F&& f)
{
    tasks.in_ranges(int(objects.size()), kObjectRange, [&](int first, int last) {
        const auto begin = std::size_t(first);
        for_each_prefetched<kLines>(objects.subspan(begin, std::size_t(last) - begin),
                                    [&](std::size_t i, T& object) { f(begin + i, object); });
    });
}

}  // namespace epode
