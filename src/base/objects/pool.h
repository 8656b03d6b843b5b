// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chunked storage for the objects behind ODE's handles. Addresses never change, and the head of a destroyed
// object stays readable, so that its overwritten tag and its generation reveal a stale handle. There is one
// pool per type and process, because handles of destroyed worlds must be recognised too. A spin lock guards
// the free list, since worlds may be built on several threads; it is held for a few instructions only. Chunks
// are kept after the last dCloseODE, for handles that outlive it, and freed when the library is unloaded.
// Chunks from a memory handler of the program are the exception: the program may withdraw its memory, so the
// last dCloseODE frees them if the pool holds no object.
#pragma once

#include <atomic>
#include <new>
#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>  // NOLINT: of glibc
#endif

#include "base/memory.h"
#include "base/objects/handle.h"
#include "base/threads/spin.h"

namespace epode {

class SpinLock {
  public:
    // A process with one thread needs no lock, and the exchange costs more than what it guards.
    void lock()
    {
        if (alone()) return taken_.store(true, std::memory_order_relaxed);
        while (taken_.exchange(true, std::memory_order_acquire)) spin_once();
    }
    // False if it is locked; there is nothing to unlock then.
    bool try_lock()
    {
        if (!alone()) return !taken_.exchange(true, std::memory_order_acquire);
        if (taken_.load(std::memory_order_relaxed)) return false;
        taken_.store(true, std::memory_order_relaxed);
        return true;
    }
    void unlock() { taken_.store(false, std::memory_order_release); }

  private:
#if __has_include(<sys/single_threaded.h>)
    static bool alone() { return __libc_single_threaded; }
#else
    static bool alone() { return false; }
#endif
    std::atomic<bool> taken_{false};
};

// The untyped part, so that the list handling exists once.
class SlotPool {
  public:
    constexpr SlotPool(std::size_t slot_size, std::size_t slots_per_chunk)
        : slot_size_((slot_size + kCacheLine - 1) & ~(kCacheLine - 1)), slots_per_chunk_(slots_per_chunk)
    {}

    void* take() noexcept;           // null when memory is exhausted; a Tagged lies or has lain there
    void give(void* slot) noexcept;  // keeps the Tagged at its beginning as it is
    std::size_t live() const { return live_; }

    // Frees chunks if no slot is in use: those from the program's memory handlers, or all.
    void trim(bool all = true) noexcept;
    static void trim_all(bool all) noexcept;  // of every pool

  private:
    struct Chunk {
        Chunk* next;
        bool foreign;  // came from a handler of the program
    };
    // The link is stored behind the tag, which must stay intact for handle checks.
    static constexpr std::size_t kHead = 24;
    static void*& link(void* slot) { return *reinterpret_cast<void**>(static_cast<char*>(slot) + 16); }
    std::size_t chunk_size() const { return kCacheLine + slot_size_ * slots_per_chunk_; }
    char* slot_of(Chunk& chunk, std::size_t i) const
    {
        return reinterpret_cast<char*>(&chunk) + kCacheLine + i * slot_size_;
    }
    bool grow();
    void enlist();
    void push_slots(Chunk& chunk);

    SpinLock lock_;
    std::size_t slot_size_;
    std::size_t slots_per_chunk_;
    std::size_t live_ = 0;
    void* free_ = nullptr;
    Chunk* chunks_ = nullptr;
    SlotPool* next_pool_ = nullptr;  // all pools that have ever held an object
    bool listed_ = false;
};

template <typename T>
class Pool {
  public:
    template <typename... Arguments>
    static T* create(Arguments&&... arguments) noexcept
    {
        void* slot = slots().take();
        if (!slot) return nullptr;
        const std::uint32_t before = static_cast<Tagged*>(slot)->generation;
        T* object = new (slot) T(static_cast<Arguments&&>(arguments)...);
        object->generation = (before + 1) % kGenerations;
        return object;
    }

    // T's destructor runs, which leaves a dead tag behind.
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
