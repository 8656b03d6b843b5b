// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Threads of a step may ask at the same time.
#include "bench/runs/memory_meter.h"

#include <ode/ode.h>

#include <atomic>
#include <cstdlib>

namespace epode::bench {

namespace {

std::atomic<std::size_t> now{0}, largest{0};

void grow(std::size_t by)
{
    const std::size_t sum = now.fetch_add(by) + by;
    for (std::size_t seen = largest.load(); seen < sum && !largest.compare_exchange_weak(seen, sum);) {}
}

void* take(dsizeint size)
{
    void* block = std::malloc(size);
    if (block) grow(size);
    return block;
}

void* resize(void* block, dsizeint old_size, dsizeint size)
{
    void* moved = std::realloc(block, size);
    if (!moved) return nullptr;
    now.fetch_sub(old_size);
    grow(size);
    return moved;
}

void give_back(void* block, dsizeint size)
{
    if (block) now.fetch_sub(size);
    std::free(block);
}

}  // namespace

void meter_memory()
{
    dSetAllocHandler(take);
    dSetReallocHandler(resize);
    dSetFreeHandler(give_back);
}

std::size_t bytes_now() { return now.load(); }
std::size_t peak_bytes() { return largest.load(); }

}  // namespace epode::bench
