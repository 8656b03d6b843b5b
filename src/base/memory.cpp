// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An aligned block is cut from a larger one; the word before the block remembers where the larger one begins.
#include "base/memory.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "base/config.h"
#include "base/float_environment.h"

namespace epode {
namespace {

std::atomic<std::size_t> g_allocations{0};

constexpr std::size_t kMargin = kCacheLine + sizeof(void*);

}  // namespace

MemoryHooks& memory_hooks() noexcept
{
    static MemoryHooks hooks;
    return hooks;
}

std::size_t allocation_count() noexcept { return g_allocations.load(std::memory_order_relaxed); }

void* raw_allocate(std::size_t size) noexcept
{
    g_allocations.fetch_add(1, std::memory_order_relaxed);
    const CallerFloatEnvironment program;
    const auto hook = memory_hooks().alloc;
    return hook ? hook(size) : std::malloc(size);
}

void* raw_reallocate(void* pointer, std::size_t old_size, std::size_t new_size) noexcept
{
    g_allocations.fetch_add(1, std::memory_order_relaxed);
    const CallerFloatEnvironment program;
    const auto hook = memory_hooks().realloc;
    return hook ? hook(pointer, old_size, new_size) : std::realloc(pointer, new_size);
}

void raw_free(void* pointer, std::size_t size) noexcept
{
    if (!pointer) return;
    const CallerFloatEnvironment program;
    const auto hook = memory_hooks().free;
    hook ? hook(pointer, size) : std::free(pointer);
}

void* allocate_from(dAllocFunction* alloc, std::size_t size) noexcept
{
    if (size > SIZE_MAX - kMargin) return nullptr;
    const CallerFloatEnvironment program;
    void* raw = alloc(size + kMargin);
    if (!raw) return nullptr;
    const auto first = reinterpret_cast<std::uintptr_t>(raw) + sizeof(void*);
    const auto aligned = (first + kCacheLine - 1) & ~(std::uintptr_t(kCacheLine) - 1);
    void* block = reinterpret_cast<void*>(aligned);
    std::memcpy(reinterpret_cast<char*>(block) - sizeof(void*), &raw, sizeof raw);
    return block;
}

void release_to(dFreeFunction* free, void* pointer, std::size_t size) noexcept
{
    if (!pointer) return;
    void* raw;
    std::memcpy(&raw, reinterpret_cast<char*>(pointer) - sizeof(void*), sizeof raw);
    const CallerFloatEnvironment program;
    free(raw, size + kMargin);
}

void* allocate(std::size_t size) noexcept { return allocate_from(&raw_allocate, size); }

void release(void* pointer, std::size_t size) noexcept { release_to(&raw_free, pointer, size); }

}  // namespace epode
