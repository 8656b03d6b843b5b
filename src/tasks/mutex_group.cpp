// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Error-checking mutexes. The group itself lies in a pool, so that a stale handle is recognised.
#include "tasks/mutex_group.h"

#include "base/objects/pool.h"

namespace epode {

MutexGroup* MutexGroup::create(dmutexindex_t count)
{
    auto* mutexes = static_cast<pthread_mutex_t*>(allocate(sizeof(pthread_mutex_t) * std::size_t(count)));
    if (!mutexes) return nullptr;
    MutexGroup* const group = Pool<MutexGroup>::create(mutexes, count);
    if (!group) {
        release(mutexes, sizeof(pthread_mutex_t) * std::size_t(count));
        return nullptr;
    }
    pthread_mutexattr_t attributes;
    pthread_mutexattr_init(&attributes);
    pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_ERRORCHECK);
    for (dmutexindex_t i = 0; i < count; ++i) pthread_mutex_init(mutexes + i, &attributes);
    pthread_mutexattr_destroy(&attributes);
    return group;
}

void MutexGroup::destroy(MutexGroup* group)
{
    for (dmutexindex_t i = 0; i < group->count; ++i) pthread_mutex_destroy(group->mutexes + i);
    release(group->mutexes, sizeof(pthread_mutex_t) * std::size_t(group->count));
    Pool<MutexGroup>::destroy(group);
}

bool MutexGroup::lock(dmutexindex_t index) { return pthread_mutex_lock(mutexes + index) == 0; }

bool MutexGroup::unlock(dmutexindex_t index) { return pthread_mutex_unlock(mutexes + index) == 0; }

bool MutexGroup::all_free()
{
    for (dmutexindex_t i = 0; i < count; ++i) {
        if (pthread_mutex_trylock(mutexes + i) != 0) return false;
        pthread_mutex_unlock(mutexes + i);
    }
    return true;
}

}  // namespace epode
