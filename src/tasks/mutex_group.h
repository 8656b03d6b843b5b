// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Several mutexes created and freed together, as ODE's threading interface has them. Each knows its owner:
// locking twice from one thread, and unlocking another thread's mutex, are refused.
#pragma once

#include "base/objects/handle.h"
#include "base/threads/system_threads.h"
#include "ode/threading.h"

namespace epode {

struct MutexGroup : Tagged {
    static MutexGroup* create(dmutexindex_t count);  // null: out of memory
    static void destroy(MutexGroup* group);

    explicit MutexGroup(pthread_mutex_t* m, dmutexindex_t n) : Tagged(Tag::kMutexGroup), mutexes(m), count(n)
    {}

    bool lock(dmutexindex_t index);    // false: this thread has it already
    bool unlock(dmutexindex_t index);  // false: this thread does not have it
    bool all_free();

    pthread_mutex_t* mutexes;
    dmutexindex_t count;
    const void* owner = nullptr;
    MutexGroup *previous = nullptr, *next = nullptr;
};
template <>
struct HandleOf<MutexGroup> {
    using Id = dMutexGroupID;
    static constexpr Tag kTag = Tag::kMutexGroup;
};

}  // namespace epode
