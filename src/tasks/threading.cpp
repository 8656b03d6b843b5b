// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The functions of the table check their arguments as the exported ones do, because programs call them
// directly.
#include "tasks/threading.h"

#include "base/check.h"
#include "base/objects/pool.h"

namespace epode {
namespace {

constexpr dmutexindex_t kMaxMutexes = 1 << 16;
constexpr std::size_t kMaxDependencies = std::size_t(1) << 31;

// The implementation behind the handle; without one the call is refused and returns the given result.
#define IMPLEMENTATION_OR(...)                           \
    Threading* const own = from_handle<Threading>(impl); \
    EPODE_USER(own __VA_OPT__(, ) __VA_ARGS__)

dMutexGroupID alloc_mutex_group(dThreadingImplementationID impl, dmutexindex_t count, const char* const*)
{
    IMPLEMENTATION_OR(nullptr);
    EPODE_USER(count > 0 && count <= kMaxMutexes, nullptr);
    const MutexGroup* const group = own->make_group(count);
    EPODE_USER_SAY(group, kOutOfMemory, nullptr);
    return to_handle(group);
}

void free_mutex_group(dThreadingImplementationID impl, dMutexGroupID group)
{
    IMPLEMENTATION_OR();
    if (!group) return;
    EPODE_USER(own->free_group(group));
}

void lock_group_mutex(dThreadingImplementationID impl, dMutexGroupID id, dmutexindex_t index)
{
    IMPLEMENTATION_OR();
    MutexGroup* const group = own->group(id);
    EPODE_USER(group && index < group->count);
    EPODE_USER_SAY(group->lock(index), "The mutex is locked by the calling thread");
}

void unlock_group_mutex(dThreadingImplementationID impl, dMutexGroupID id, dmutexindex_t index)
{
    IMPLEMENTATION_OR();
    MutexGroup* const group = own->group(id);
    EPODE_USER(group && index < group->count);
    EPODE_USER_SAY(group->unlock(index), "The mutex is not locked by the calling thread");
}

dCallWaitID alloc_call_wait(dThreadingImplementationID impl)
{
    IMPLEMENTATION_OR(nullptr);
    return to_handle(own->calls.make_wait());  // a step that gets none reports the lack of memory itself
}

void reset_call_wait(dThreadingImplementationID impl, dCallWaitID wait)
{
    IMPLEMENTATION_OR();
    EPODE_USER(own->calls.reset_wait(wait));
}

void free_call_wait(dThreadingImplementationID impl, dCallWaitID wait)
{
    IMPLEMENTATION_OR();
    if (!wait) return;
    EPODE_USER(own->calls.free_wait(wait));
}

// A refused call counts as one that failed.
void post_call(dThreadingImplementationID impl, int* fault, dCallReleaseeID* releasee,
               ddependencycount_t dependencies, dCallReleaseeID dependent, dCallWaitID wait,
               dThreadedCallFunction* function, void* context, dcallindex_t index, const char*)
{
    if (releasee) *releasee = nullptr;
    IMPLEMENTATION_OR((void)(fault && (*fault = 1)));
    EPODE_USER(function && dependencies <= kMaxDependencies, (void)(fault && (*fault = 1)));
    const CallQueue::Posted posted =
        own->calls.post({function, context, index, dependencies, dependent, wait, fault, releasee});
    EPODE_USER_SAY(posted != CallQueue::Posted::kNoMemory, kOutOfMemory);
    EPODE_USER(posted == CallQueue::Posted::kYes, (void)(fault && (*fault = 1)));
}

void alter_call_dependencies_count(dThreadingImplementationID impl, dCallReleaseeID call,
                                   ddependencychange_t change)
{
    IMPLEMENTATION_OR();
    EPODE_USER(own->calls.alter(call, change));
}

void wait_call(dThreadingImplementationID impl, int* status, dCallWaitID wait,
               const dThreadedWaitTime* timeout, const char*)
{
    if (status) *status = 0;
    IMPLEMENTATION_OR();
    const CallQueue::Waited waited = own->calls.wait(
        wait, timeout ? Deadline::after(timeout->wait_sec, timeout->wait_nsec) : Deadline::never());
    EPODE_USER(waited != CallQueue::Waited::kUnknown);
    EPODE_USER_SAY(waited != CallQueue::Waited::kForEver, "The wait would be for ever");
    if (status) *status = waited == CallQueue::Waited::kDone;
}

unsigned retrieve_thread_count(dThreadingImplementationID impl)
{
    IMPLEMENTATION_OR(0);
    return own->calls.closed() ? 0 : own->calls.serving();
}

int preallocate_resources_for_calls(dThreadingImplementationID impl, ddependencycount_t calls)
{
    IMPLEMENTATION_OR(0);
    return own->calls.reserve(calls);
}

#undef IMPLEMENTATION_OR

}  // namespace

Threading::Threading(bool served_by_threads)
    : Tagged(Tag::kThreading),
      served(served_by_threads),
      calls(served_by_threads),
      watch_(ForkRank::kServingPool, this, [](void* self, ForkStage stage) {
          Lock& lock = static_cast<Threading*>(self)->lock_;
          stage == ForkStage::kBefore ? lock.lock() : lock.unlock();
      })
{}

Threading::~Threading()
{
    while (MutexGroup* group = groups_) {
        groups_ = group->next;
        MutexGroup::destroy(group);
    }
}

MutexGroup* Threading::make_group(dmutexindex_t count)
{
    MutexGroup* const made = MutexGroup::create(count);
    if (!made) return nullptr;
    made->owner = this;
    Guard guard(lock_);
    made->next = groups_;
    if (groups_) groups_->previous = made;
    groups_ = made;
    return made;
}

MutexGroup* Threading::group(dMutexGroupID id) const
{
    MutexGroup* const group = from_handle<MutexGroup>(id);
    return group && group->owner == this ? group : nullptr;
}

bool Threading::free_group(dMutexGroupID id)
{
    Guard guard(lock_);
    MutexGroup* const dying = group(id);
    if (!dying || !dying->all_free()) return false;
    (dying->previous ? dying->previous->next : groups_) = dying->next;
    if (dying->next) dying->next->previous = dying->previous;
    MutexGroup::destroy(dying);
    return true;
}

const dThreadingFunctionsInfo& threading_functions()
{
    static constexpr dThreadingFunctionsInfo table = {sizeof(dThreadingFunctionsInfo),
                                                      alloc_mutex_group,
                                                      free_mutex_group,
                                                      lock_group_mutex,
                                                      unlock_group_mutex,
                                                      alloc_call_wait,
                                                      reset_call_wait,
                                                      free_call_wait,
                                                      post_call,
                                                      alter_call_dependencies_count,
                                                      wait_call,
                                                      retrieve_thread_count,
                                                      preallocate_resources_for_calls};
    return table;
}

bool complete(const dThreadingFunctionsInfo& f)
{
    return f.struct_size >= sizeof f && f.alloc_mutex_group && f.free_mutex_group && f.lock_group_mutex &&
           f.unlock_group_mutex && f.alloc_call_wait && f.reset_call_wait && f.free_call_wait &&
           f.post_call && f.alter_call_dependencies_count && f.wait_call && f.retrieve_thread_count &&
           f.preallocate_resources_for_calls;
}

}  // namespace epode
