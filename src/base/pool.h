// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chunked storage for the objects behind ODE's handles: addresses never change, and the memory of a destroyed
// object stays readable, so that its overwritten tag can unmask a stale handle. Chunks are therefore kept
// until the last object of the pool is gone and `trim` is called (dCloseODE). One pool per type and process:
// handles of a destroyed world must be recognised too. A spin lock guards the free list, because worlds may
// be built on several threads; held for a few instructions only.
#pragma once

#include <atomic>
#include <new>

#include "base/memory.h"

namespace epode {

class SpinLock {
  public:
    void lock()
    {
        while (flag_.test_and_set(std::memory_order_acquire)) __builtin_ia32_pause();
    }
    void unlock() { flag_.clear(std::memory_order_release); }

  private:
    std::atomic_flag flag_ = ATOMIC_FLAG_INIT;
};

// Untyped part, so that the list handling exists once.
class SlotPool {
  public:
    constexpr SlotPool(std::size_t slot_size, std::size_t slots_per_chunk)
        : slot_size_((slot_size + kCacheLine - 1) & ~(kCacheLine - 1)), slots_per_chunk_(slots_per_chunk)
    {}

    void* take() noexcept;           // null when memory is exhausted
    void give(void* slot) noexcept;  // keeps the first 16 bytes of the slot (its tag) as they are
    void trim() noexcept;            // frees all chunks if no slot is in use
    std::size_t live() const { return live_; }

  private:
    static constexpr std::size_t kCacheLine = 64;
    struct Chunk {
        Chunk* next;
    };
    // The link lies behind the tag word, which must survive for handle checks.
    static void*& link(void* slot) { return *reinterpret_cast<void**>(static_cast<char*>(slot) + 16); }
    bool grow();

    SpinLock lock_;
    std::size_t slot_size_;
    std::size_t slots_per_chunk_;
    std::size_t live_ = 0;
    void* free_ = nullptr;
    Chunk* chunks_ = nullptr;
};

template <typename T>
class Pool {
  public:
    template <typename... Arguments>
    static T* create(Arguments&&... arguments) noexcept
    {
        void* slot = slots().take();
        return slot ? new (slot) T(static_cast<Arguments&&>(arguments)...) : nullptr;
    }

    // T's destructor runs; T must have put a dead tag into its first 16 bytes by then.
    static void destroy(T* object) noexcept
    {
        object->~T();
        slots().give(object);
    }

    static SlotPool& slots() noexcept
    {
        static SlotPool pool(sizeof(T), 64);
        return pool;
    }
};

}  // namespace epode
