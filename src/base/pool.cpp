// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Free slots form a stack, so the slot given last is taken first: a frame's contact joints come back warm.
#include "base/pool.h"

#include <mutex>

namespace epode {

void* SlotPool::take() noexcept
{
    std::lock_guard guard(lock_);
    if (!free_ && !grow()) return nullptr;
    void* slot = free_;
    free_ = link(slot);
    ++live_;
    return slot;
}

void SlotPool::give(void* slot) noexcept
{
    std::lock_guard guard(lock_);
    link(slot) = free_;
    free_ = slot;
    --live_;
}

void SlotPool::trim() noexcept
{
    std::lock_guard guard(lock_);
    if (live_) return;
    while (chunks_) {
        Chunk* next = chunks_->next;
        release(chunks_, kCacheLine + slot_size_ * slots_per_chunk_);
        chunks_ = next;
    }
    free_ = nullptr;
}

bool SlotPool::grow()
{
    char* memory = static_cast<char*>(allocate(kCacheLine + slot_size_ * slots_per_chunk_));
    if (!memory) return false;
    auto* chunk = reinterpret_cast<Chunk*>(memory);
    chunk->next = chunks_;
    chunks_ = chunk;
    // Pushed from the last to the first, so that slots are handed out in address order.
    for (std::size_t i = slots_per_chunk_; i-- > 0;) {
        void* slot = memory + kCacheLine + i * slot_size_;
        link(slot) = free_;
        free_ = slot;
    }
    return true;
}

}  // namespace epode
