// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All memory of the library comes from the client's dSetAllocHandler family. Every allocation may fail, and
// callers test for null. `allocate` returns memory aligned to `alignment` whatever the client's hook does.
#pragma once

#include <cstddef>

#include "ode/memory.h"

namespace epode {

struct MemoryHooks {
    dAllocFunction* alloc = nullptr;
    dReallocFunction* realloc = nullptr;
    dFreeFunction* free = nullptr;
};

MemoryHooks& memory_hooks() noexcept;

// Straight through the hooks, malloc alignment: what dAlloc, dRealloc and dFree do.
void* raw_allocate(std::size_t size) noexcept;
void* raw_reallocate(void* pointer, std::size_t old_size, std::size_t new_size) noexcept;
void raw_free(void* pointer, std::size_t size) noexcept;

// 64-byte aligned blocks over the hooks. `release` takes the size that was asked for.
void* allocate(std::size_t size) noexcept;
void release(void* pointer, std::size_t size) noexcept;

// The same with a pair of the client's functions (step memory). Both see the size with its margin, the same
// value both times.
void* allocate_from(dAllocFunction* alloc, std::size_t size) noexcept;
void release_to(dFreeFunction* free, void* pointer, std::size_t size) noexcept;

// The number of allocations of the process. Tests use it to prove that a warm step makes none.
std::size_t allocation_count() noexcept;

}  // namespace epode
