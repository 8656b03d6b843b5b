// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free slots form a stack, so the slot freed last is reused first: the contact joints of a frame come back
// while still in the cache.
#include "base/objects/pool.h"

#include <algorithm>
#include <mutex>

#include "base/objects/lifecycle.h"
#include "base/poison.h"

namespace epode {
namespace {

std::atomic<SlotPool*> g_pools{nullptr};  // new pools are added at the front

void trim_foreign() { SlotPool::trim_all(false); }

// A host that unloads the library gets all memory back. Handlers of the program may be gone by then, so
// memory that came from them is left alone.
[[gnu::destructor]] void trim_at_unload()
{
    if (!memory_hooks().free) SlotPool::trim_all(true);
}

// More objects will probably be created soon: contacts come by the thousand, usually in slots at equal
// distances. Taking the step to the next slot four times leads to the fourth slot from here, which is
// prefetched for writing.
void prefetch_to_write(const void* slot, const void* next, std::size_t size)
{
    constexpr std::size_t kMaxBytes = 4 * kCacheLine;
    const auto here = reinterpret_cast<std::uintptr_t>(slot), there = reinterpret_cast<std::uintptr_t>(next);
    const std::uintptr_t ahead = there + 3 * (there - here);
    for (std::size_t i = 0; i < std::min(size, kMaxBytes); i += kCacheLine)
        __builtin_prefetch(reinterpret_cast<const void*>(ahead + i), 1);
}

}  // namespace

void* SlotPool::take() noexcept
{
    std::lock_guard guard(lock_);
    if (!free_ && !grow()) return nullptr;
    void* slot = free_;
    free_ = link(slot);
    if (free_) prefetch_to_write(slot, free_, slot_size_);
    ++live_;
    unpoison(slot, slot_size_);
    return slot;
}

void SlotPool::give(void* slot) noexcept
{
    std::lock_guard guard(lock_);
    link(slot) = free_;
    free_ = slot;
    --live_;
    poison(static_cast<char*>(slot) + kHead, slot_size_ - kHead);
}

bool SlotPool::grow()
{
    const bool foreign = memory_hooks().alloc != nullptr;
    auto* chunk = static_cast<Chunk*>(allocate(chunk_size()));
    if (!chunk) return false;
    *chunk = {chunks_, foreign};
    chunks_ = chunk;
    for (std::size_t i = 0; i < slots_per_chunk_; ++i) {
        new (slot_of(*chunk, i)) Tagged(Tag::kDead);
        poison(slot_of(*chunk, i) + kHead, slot_size_ - kHead);
    }
    push_slots(*chunk);
    if (!listed_) enlist();
    return true;
}

void SlotPool::enlist()
{
    listed_ = true;
    (void)on_last_close(trim_foreign);
    next_pool_ = g_pools.load();
    while (!g_pools.compare_exchange_weak(next_pool_, this)) {}
}

// From last to first, so that slots are handed out in the order of their addresses.
void SlotPool::push_slots(Chunk& chunk)
{
    for (std::size_t i = slots_per_chunk_; i-- > 0;) {
        void* slot = slot_of(chunk, i);
        link(slot) = free_;
        free_ = slot;
    }
}

void SlotPool::trim(bool all) noexcept
{
    std::lock_guard guard(lock_);
    if (live_) return;
    Chunk* kept = nullptr;
    while (chunks_) {
        Chunk* chunk = chunks_;
        chunks_ = chunk->next;
        if (all || chunk->foreign) {
            unpoison(chunk, chunk_size());
            release(chunk, chunk_size());
        } else {
            chunk->next = kept;
            kept = chunk;
        }
    }
    chunks_ = kept;
    free_ = nullptr;
    for (Chunk* chunk = chunks_; chunk; chunk = chunk->next) push_slots(*chunk);
}

void SlotPool::trim_all(bool all) noexcept
{
    for (SlotPool* pool = g_pools.load(); pool; pool = pool->next_pool_) pool->trim(all);
}

}  // namespace epode
