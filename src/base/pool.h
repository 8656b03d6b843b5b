// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chunked storage for the objects behind ODE's handles: addresses never change, and the head of a destroyed
// object stays readable, so that its overwritten tag and its generation can unmask a stale handle. One pool
// per type and process: handles of a destroyed world must be recognised too. A spin lock guards the free
// list, because worlds may be built on several threads; held for a few instructions only.
// Chunks are kept even after the last dCloseODE, for the sake of handles that outlive it, and go with the
// library itself. Those that a memory handler of the program has given are the exception: the program may
// take its heap away then, so the last dCloseODE gives them back when no object of the pool is left.
#pragma once

#include <atomic>
#include <new>
#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>  // NOLINT: of glibc
#endif

#include "base/handle.h"
#include "base/memory.h"
#include "base/spin.h"

namespace epode {

class SpinLock {
  public:
    // While the process has one thread nobody is in the way, and an exchange costs more than what it guards.
    void lock()
    {
        if (alone()) return taken_.store(true, std::memory_order_relaxed);
        while (taken_.exchange(true, std::memory_order_acquire)) spin_once();
    }
    // False, and nothing to unlock, when it is locked.
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

// Untyped part, so that the list handling exists once.
class SlotPool {
  public:
    constexpr SlotPool(std::size_t slot_size, std::size_t slots_per_chunk)
        : slot_size_((slot_size + kCacheLine - 1) & ~(kCacheLine - 1)), slots_per_chunk_(slots_per_chunk)
    {}

    void* take() noexcept;           // null when memory is exhausted; a Tagged lies or has lain there
    void give(void* slot) noexcept;  // keeps the Tagged at its beginning as it is
    std::size_t live() const { return live_; }

    // Gives chunks back, if no slot is in use: those of the program's memory handlers, or all.
    void trim(bool all = true) noexcept;
    static void trim_all(bool all) noexcept;  // of every pool

  private:
    struct Chunk {
        Chunk* next;
        bool foreign;  // came from a handler of the program
    };
    // The link lies behind the tag, which must survive for handle checks.
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
    SlotPool* next_pool_ = nullptr;  // of all that have ever held something
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
