// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Behind dThreadingImplementationID: a queue of calls, groups of mutexes, and the table of functions through
// which a world or a client's program uses them. The self-threaded kind is the one that no thread may serve.
#pragma once

#include "tasks/call_queue.h"
#include "tasks/mutex_group.h"

namespace epode {

struct Threading : Tagged {
    explicit Threading(bool served_by_threads);
    ~Threading();

    MutexGroup* make_group(dmutexindex_t count);
    MutexGroup* group(dMutexGroupID id) const;  // null: not one of this implementation's
    bool free_group(dMutexGroupID id);          // false: not ours, or a mutex of it is locked

    const bool served;
    CallQueue calls;

  private:
    Lock lock_;  // of the list of groups
    MutexGroup* groups_ = nullptr;
    ForkWatch watch_;
};
template <>
struct HandleOf<Threading> {
    using Id = dThreadingImplementationID;
    static constexpr Tag kTag = Tag::kThreading;
};

// Our table; the same for both kinds.
const dThreadingFunctionsInfo& threading_functions();

// True if a client's table is large enough and lacks no function.
bool complete(const dThreadingFunctionsInfo& functions);

}  // namespace epode
