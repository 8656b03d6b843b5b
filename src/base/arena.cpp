// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How an arena gets and returns its blocks. The client's memory functions are called by one thread at a time:
// the workers of a step may grow their arenas at the same moment, but a client that replaces the step memory
// expects one stepping thread. The lock is recursive because a client may step another world inside such a
// call.
#include "base/arena.h"

#include <mutex>

#include "base/check.h"
#include "base/threads/system_threads.h"

namespace epode {
namespace {

class RecursiveLock {
  public:
    RecursiveLock()
    {
        pthread_mutexattr_t attributes;
        pthread_mutexattr_init(&attributes);
        pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_RECURSIVE);
        pthread_mutex_init(&mutex_, &attributes);
        pthread_mutexattr_destroy(&attributes);
    }
    void lock() { pthread_mutex_lock(&mutex_); }
    void unlock() { pthread_mutex_unlock(&mutex_); }

  private:
    pthread_mutex_t mutex_;
};

// Never destroyed: an arena may outlive the library's other statics.
RecursiveLock& client_functions()
{
    static RecursiveLock lock;
    return lock;
}

void* take_block(const ArenaSupply& supply, std::size_t size)
{
    if (!supply.alloc) return allocate(size);
    std::lock_guard guard(client_functions());
    return allocate_from(supply.alloc, size);
}

void give_block(dFreeFunction* free, void* block, std::size_t size)
{
    if (!free) return release(block, size);
    std::lock_guard guard(client_functions());
    release_to(free, block, size);
}

}  // namespace

bool Arena::add_block(std::size_t size)
{
    EPODE_ASSERT(!current_ || used_ <= current_->size);
    if (size > SIZE_MAX - kHeader) return false;
    auto* block = static_cast<ArenaBlock*>(take_block(supply_, size + kHeader));
    if (!block) return false;
    *block = {nullptr, size, supply_.alloc ? supply_.free : nullptr};
    poison(memory_of(block), size);
    if (current_) current_->next = block;
    if (!first_) first_ = block;
    current_ = block;
    used_ = 0;
    return true;
}

void Arena::free_all()
{
    while (first_) {
        ArenaBlock* const block = first_;
        first_ = block->next;
        unpoison(memory_of(block), block->size);
        give_block(block->free, block, block->size + kHeader);
    }
    current_ = nullptr;
    used_ = 0;
}

}  // namespace epode
