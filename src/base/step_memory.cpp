// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The first step that needs further workers creates their arenas, and they stay until the last holder is
// gone; before that only their blocks can be freed.
#include "base/step_memory.h"

#include <new>

#include "base/call_guard.h"

namespace epode {

StepMemory* StepMemory::create()
{
    void* place = allocate(sizeof(StepMemory));
    return place ? new (place) StepMemory : nullptr;
}

StepMemory* StepMemory::hold()
{
    holders_.fetch_add(1, std::memory_order_relaxed);
    return this;
}

void StepMemory::let_go(StepMemory* memory)
{
    if (!memory || memory->holders_.fetch_sub(1, std::memory_order_acq_rel) > 1) return;
    memory->~StepMemory();
    release(memory, sizeof(StepMemory));
}

StepMemory::~StepMemory()
{
    for (Arena* arena : others_) {
        arena->~Arena();
        release(arena, sizeof(Arena));
    }
}

bool StepMemory::begin()
{
    if (in_use_.exchange(true, std::memory_order_acquire)) return false;
    own_.reset();
    return true;
}

bool StepMemory::still_in_use() const
{
    CallGuard::release_left();
    return in_use_.load(std::memory_order_relaxed);
}

bool StepMemory::provide(int workers)
{
    while (others_.size() < workers - 1) {
        void* place = allocate(sizeof(Arena));
        if (!place) return false;
        Arena* const arena = new (place) Arena;
        arena->set_supply(supply_);
        if (!others_.push(arena)) {
            release(place, sizeof(Arena));
            return false;
        }
    }
    for (Arena* arena : others_) {
        arena->reset();
        arena->open();  // a worker that starts late must not allocate then
    }
    return true;
}

void StepMemory::set_supply(const ArenaSupply& supply)
{
    supply_ = supply;
    own_.set_supply(supply);
    for (Arena* arena : others_) arena->set_supply(supply);
}

void StepMemory::free_blocks()
{
    own_.free_blocks();
    for (Arena* arena : others_) arena->free_blocks();
}

}  // namespace epode
