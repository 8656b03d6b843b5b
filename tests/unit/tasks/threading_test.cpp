// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library's own threading implementations through their table, as a program calls it: order,
// dependencies, faults, waits with limits, mutexes, life and death, and what is refused.
#include <gtest/gtest.h>
#include <ode/ode.h>
#if !defined(_WIN32) && !defined(__wasm__)
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "../api/message_recorder.h"

namespace epode {
namespace {

// An implementation, self-threaded or served by `threads` of a pool.
struct Implementation {
    explicit Implementation(unsigned threads)
    {
        dInitODE2(0);
        id = threads ? dThreadingAllocateMultiThreadedImplementation()
                     : dThreadingAllocateSelfThreadedImplementation();
        f = dThreadingImplementationGetFunctions(id);
        if (!threads) return;
        pool = dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, id);
    }
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation()
    {
        dThreadingImplementationShutdownProcessing(id);
        dThreadingFreeThreadPool(pool);
        dThreadingFreeImplementation(id);
        dCloseODE();
    }

    dCallReleaseeID post(dThreadedCallFunction* call, void* context, dcallindex_t index = 0,
                         dCallReleaseeID dependent = nullptr, std::size_t dependencies = 0,
                         dCallWaitID wait = nullptr, int* fault = nullptr) const
    {
        dCallReleaseeID name = nullptr;
        f->post_call(id, fault, &name, dependencies, dependent, wait, call, context, index, "test");
        return name;
    }
    int await(dCallWaitID wait, const dThreadedWaitTime* limit = nullptr) const
    {
        int status = -1;
        f->wait_call(id, &status, wait, limit, "test");
        return status;
    }

    dThreadingImplementationID id = nullptr;
    const dThreadingFunctionsInfo* f = nullptr;
    dThreadingThreadPoolID pool = nullptr;
};

#if defined(__wasm__)
constexpr unsigned kKinds[] = {0};  // self-threaded: there are no pools
#else
constexpr unsigned kKinds[] = {0, 1, 2, 4};  // threads; 0: self-threaded
#endif
constexpr dThreadedWaitTime kAtOnce = {0, 0}, kMoment = {0, 20 * 1000 * 1000}, kLong = {20, 0};

struct Log {
    std::mutex lock;
    std::vector<int> order;
    std::set<std::thread::id> threads;

    static int note(void* self, dcallindex_t index, dCallReleaseeID)
    {
        Log& log = *static_cast<Log*>(self);
        const std::lock_guard guard(log.lock);
        log.order.push_back(int(index));
        log.threads.insert(std::this_thread::get_id());
        return 1;
    }
    static int fail(void* self, dcallindex_t index, dCallReleaseeID)
    {
        note(self, index, nullptr);
        return 0;
    }
};

TEST(Tasks, the_self_threaded_implementation_runs_the_last_call_first_on_the_thread_that_waits)
{
    const Implementation impl(0);
    EXPECT_EQ(impl.f->struct_size, sizeof(dThreadingFunctionsInfo));
    EXPECT_EQ(impl.f->retrieve_thread_count(impl.id), 0u);
    EXPECT_EQ(impl.f->preallocate_resources_for_calls(impl.id, 100), 1);
    Log log;
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    for (int i = 0; i < 50; ++i) impl.post(Log::note, &log, dcallindex_t(i), nullptr, 0, wait);
    EXPECT_TRUE(log.order.empty());
    EXPECT_EQ(impl.await(wait), 1);
    ASSERT_EQ(log.order.size(), 50u);
    for (int i = 0; i < 50; ++i) EXPECT_EQ(log.order[std::size_t(i)], 49 - i);
    EXPECT_EQ(log.threads, std::set{std::this_thread::get_id()});
    impl.f->free_call_wait(impl.id, wait);
}

TEST(Tasks, pool_threads_run_the_calls_and_the_waiting_thread_none)
{
    const Implementation impl(3);
    EXPECT_EQ(impl.f->retrieve_thread_count(impl.id), 3u);
    Log log;
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    for (int i = 0; i < 300; ++i) impl.post(Log::note, &log, dcallindex_t(i), nullptr, 0, wait);
    EXPECT_EQ(impl.await(wait), 1);
    std::sort(log.order.begin(), log.order.end());
    for (int i = 0; i < 300; ++i) ASSERT_EQ(log.order[std::size_t(i)], i);
    EXPECT_FALSE(log.threads.contains(std::this_thread::get_id()));
    EXPECT_LE(log.threads.size(), 3u);
    impl.f->free_call_wait(impl.id, wait);
}

TEST(Tasks, a_call_starts_after_those_it_depends_on)
{
    for (unsigned kind : kKinds) {
        const Implementation impl(kind);
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        for (int round = 0; round < 50; ++round) {
            // A tree: the root waits for 3, each of which waits for 4.
            Log log;
            impl.f->reset_call_wait(impl.id, wait);
            const auto root = impl.post(Log::note, &log, 100, nullptr, 3, wait);
            for (int k = 0; k < 3; ++k) {
                const auto branch = impl.post(Log::note, &log, dcallindex_t(10 + k), root, 4);
                for (int i = 0; i < 4; ++i) impl.post(Log::note, &log, dcallindex_t(k), branch);
            }
            ASSERT_EQ(impl.await(wait, &kLong), 1);
            ASSERT_EQ(log.order.size(), 16u);
            EXPECT_EQ(log.order.back(), 100);
            for (int k = 0; k < 3; ++k) {
                const auto branch = std::find(log.order.begin(), log.order.end(), 10 + k);
                EXPECT_EQ(std::count(log.order.begin(), branch, k), 4);
            }
        }
        impl.f->free_call_wait(impl.id, wait);
    }
}

TEST(Tasks, faults_gather_along_the_dependencies)
{
    for (unsigned kind : kKinds) {
        const Implementation impl(kind);
        Log log;
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        int good = 7, bad = 7, all = 7, own = 7;
        const auto root = impl.post(Log::note, &log, 0, nullptr, 2, wait, &all);
        impl.post(Log::note, &log, 1, root, 0, nullptr, &good);
        impl.post(Log::fail, &log, 2, root, 0, nullptr, &bad);
        impl.post(Log::fail, &log, 3, nullptr, 0, wait, &own);
        ASSERT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(good, 0);
        EXPECT_EQ(bad, 1);
        EXPECT_EQ(all, 1);
        EXPECT_EQ(own, 1);
        impl.f->reset_call_wait(impl.id, wait);
        impl.post(Log::note, &log, 4, nullptr, 0, wait, &all);
        ASSERT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(all, 0);
        impl.f->free_call_wait(impl.id, wait);
    }
}

struct Sprout {
    const Implementation* impl;
    Log log;
    int levels;
};

// Posts two calls that it depends on itself, down to the last level: they may run after it has returned.
int sprout(void* context, dcallindex_t level, dCallReleaseeID self)
{
    auto& s = *static_cast<Sprout*>(context);
    Log::note(&s.log, level, nullptr);
    if (int(level) == s.levels) return 0;
    s.impl->f->alter_call_dependencies_count(s.impl->id, self, 3);
    for (int i = 0; i < 2; ++i) s.impl->post(sprout, context, level + 1, self);
    s.impl->f->alter_call_dependencies_count(s.impl->id, self, -1);
    return 1;
}

TEST(Tasks, a_running_call_may_depend_on_calls_that_it_posts)
{
    for (unsigned kind : kKinds) {
        const Implementation impl(kind);
        Sprout s{&impl, {}, 7};
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        int fault = 7;
        impl.post(sprout, &s, 0, nullptr, 0, wait, &fault);
        ASSERT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(s.log.order.size(), 255u);
        EXPECT_EQ(fault, 1);  // of the last level
        impl.f->free_call_wait(impl.id, wait);
    }
}

TEST(Tasks, dependencies_may_be_taken_back)
{
    for (unsigned kind : kKinds) {
        MessageRecorder messages;
        const Implementation impl(kind);
        Log log;
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        const auto call = impl.post(Log::note, &log, 0, nullptr, 1, wait);
        impl.f->alter_call_dependencies_count(impl.id, call, 2);
        impl.post(Log::note, &log, 1, call);
        EXPECT_EQ(impl.await(wait, &kMoment), 0);
        impl.f->alter_call_dependencies_count(impl.id, call, -3);  // one of three may be done already
        impl.f->alter_call_dependencies_count(impl.id, call, -2);
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in alter_call_dependencies_count()");
        EXPECT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(log.order, (std::vector<int>{1, 0}));
        impl.f->alter_call_dependencies_count(impl.id, call, 1);  // it is done
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in alter_call_dependencies_count()");
        impl.f->free_call_wait(impl.id, wait);
    }
}

int hold(void* context, dcallindex_t, dCallReleaseeID)
{
    auto& open = *static_cast<std::atomic<bool>*>(context);
    while (!open) std::this_thread::yield();
    return 1;
}

TEST(Tasks, a_wait_ends_with_its_time)
{
    const Implementation impl(1);
    std::atomic<bool> open{false};
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    impl.post(hold, &open, 0, nullptr, 0, wait);
    EXPECT_EQ(impl.await(wait, &kAtOnce), 0);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(impl.await(wait, &kMoment), 0);
    const auto waited = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(waited, std::chrono::milliseconds(19));
    EXPECT_LT(waited, std::chrono::seconds(10));
    const dThreadedWaitTime before{-5, 0};
    EXPECT_EQ(impl.await(wait, &before), 0);
    open = true;
    const dThreadedWaitTime ages{time_t(1) << 62, ~0ul};
    EXPECT_EQ(impl.await(wait, &ages), 1);
    EXPECT_EQ(impl.await(wait, &kAtOnce), 1);
    impl.f->reset_call_wait(impl.id, wait);
    EXPECT_EQ(impl.await(wait, &kAtOnce), 0);
    impl.f->free_call_wait(impl.id, wait);
}

struct Nested {
    const Implementation* impl;
    Log log;
    std::atomic<int> status{0};
};

int wait_inside(void* context, dcallindex_t, dCallReleaseeID)
{
    auto& n = *static_cast<Nested*>(context);
    const dCallWaitID wait = n.impl->f->alloc_call_wait(n.impl->id);
    for (int i = 0; i < 5; ++i) n.impl->post(Log::note, &n.log, 0, nullptr, 0, wait);
    n.status += n.impl->await(wait);
    n.impl->f->free_call_wait(n.impl->id, wait);
    return 1;
}

TEST(Tasks, a_wait_inside_a_call_does_not_starve)
{
    for (unsigned kind : kKinds) {
        const Implementation impl(kind);
        Nested n{&impl, {}, {}};
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        for (int i = 0; i < 8; ++i) impl.post(wait_inside, &n, 0, nullptr, 0, wait);
        EXPECT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(n.status, 8);
        EXPECT_EQ(n.log.order.size(), 40u);
        impl.f->free_call_wait(impl.id, wait);
    }
}

struct Own {
    const Implementation* impl;
    dCallWaitID wait;
    int status;
};

int wait_for_itself(void* context, dcallindex_t, dCallReleaseeID)
{
    auto& own = *static_cast<Own*>(context);
    own.status = own.impl->await(own.wait);
    return 1;
}

TEST(Tasks, a_wait_that_nothing_can_end_is_refused)
{
    for (unsigned kind : kKinds) {
        MessageRecorder messages;
        const Implementation impl(kind);
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        EXPECT_EQ(impl.await(wait), 0);
        EXPECT_EQ(messages.take(), "2: The wait would be for ever in wait_call()");
        Own own{&impl, wait, -1};
        impl.post(wait_for_itself, &own, 0, nullptr, 0, wait);
        EXPECT_EQ(impl.await(wait), 1);
        EXPECT_EQ(own.status, 0);
        EXPECT_EQ(messages.take(), "2: The wait would be for ever in wait_call()");
        impl.f->free_call_wait(impl.id, wait);
    }
    const Implementation alone(0);
    MessageRecorder messages;
    Log log;
    const dCallWaitID wait = alone.f->alloc_call_wait(alone.id);
    alone.post(Log::note, &log, 0, nullptr, 1, wait);
    EXPECT_EQ(alone.await(wait), 0);
    EXPECT_EQ(messages.take(), "2: The wait would be for ever in wait_call()");
}

TEST(Tasks, without_serving_threads_the_waiting_thread_does_the_work)
{
    dInitODE2(0);
    const dThreadingImplementationID id = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(id);
    const dCallWaitID wait = f->alloc_call_wait(id);
    Log log;
    int status = 0;
    f->post_call(id, nullptr, nullptr, 0, nullptr, wait, Log::note, &log, 0, nullptr);
    f->wait_call(id, &status, wait, nullptr, nullptr);
    EXPECT_EQ(status, 1);
    EXPECT_EQ(log.threads, std::set{std::this_thread::get_id()});
    dThreadingFreeImplementation(id);  // and the wait with it
    dCloseODE();
}

TEST(Tasks, threads_of_the_program_serve_until_the_shutdown_and_again_after_a_restart)
{
    const dThreadingImplementationID id = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(id);
    for (int round = 0; round < 5; ++round) {
        std::atomic<int> ready{0};
        std::vector<std::thread> threads;
        for (int i = 0; i < 3; ++i)
            threads.emplace_back([&] {
                dExternalThreadingServeMultiThreadedImplementation(
                    id, [](void* count) { ++*static_cast<std::atomic<int>*>(count); }, &ready);
            });
        while (ready < 3) std::this_thread::yield();
        EXPECT_EQ(f->retrieve_thread_count(id), 3u);
        const dCallWaitID wait = f->alloc_call_wait(id);
        Log log;
        for (int i = 0; i < 20; ++i)
            f->post_call(id, nullptr, nullptr, 0, nullptr, wait, Log::note, &log, 0, nullptr);
        f->wait_call(id, nullptr, wait, nullptr, nullptr);
        EXPECT_EQ(log.order.size(), 20u);
        f->free_call_wait(id, wait);
        dThreadingImplementationShutdownProcessing(id);
        for (std::thread& t : threads) t.join();
        EXPECT_EQ(f->retrieve_thread_count(id), 0u);
        int late = 0;  // after the shutdown: in and out
        dExternalThreadingServeMultiThreadedImplementation(
            id, [](void* count) { ++*static_cast<int*>(count); }, &late);
        EXPECT_EQ(late, 1);
        dThreadingImplementationCleanupForRestart(id);
    }
    dThreadingFreeImplementation(id);
}

TEST(Tasks, one_pool_serves_implementations_in_turn)
{
    dInitODE2(0);
    const dThreadingThreadPoolID pool = dThreadingAllocateThreadPool(2, 256 * 1024, ~0u, nullptr);
    ASSERT_NE(pool, nullptr);
    dThreadingThreadPoolWaitIdleState(pool);
    for (int round = 0; round < 30; ++round) {
        const dThreadingImplementationID id = dThreadingAllocateMultiThreadedImplementation();
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, id);
        const dThreadingFunctionsInfo* f = dThreadingImplementationGetFunctions(id);
        EXPECT_EQ(f->retrieve_thread_count(id), 2u);
        dThreadingImplementationShutdownProcessing(id);
        if (round % 3 == 0) dThreadingThreadPoolWaitIdleState(pool);
        dThreadingFreeImplementation(id);
    }
    dThreadingFreeThreadPool(pool);
    dCloseODE();
}

TEST(Tasks, what_is_in_use_is_not_freed)
{
    MessageRecorder messages;
    const Implementation impl(2), other(2), self(0);
    const char* kServe = "2: Threads serve that have not been released by a shutdown in ";
    dThreadingFreeThreadPool(impl.pool);
    EXPECT_EQ(messages.take(), kServe + std::string("dThreadingFreeThreadPool()"));
    dThreadingThreadPoolWaitIdleState(impl.pool);
    EXPECT_EQ(messages.take(), kServe + std::string("dThreadingThreadPoolWaitIdleState()"));
    dThreadingThreadPoolServeMultiThreadedImplementation(impl.pool, other.id);
    EXPECT_EQ(messages.take(),
              kServe + std::string("dThreadingThreadPoolServeMultiThreadedImplementation()"));
    dThreadingFreeImplementation(impl.id);
    EXPECT_EQ(messages.take(), "2: Threads serve, wait or run calls in dThreadingFreeImplementation()");
    dThreadingImplementationShutdownProcessing(self.id);
    dThreadingImplementationCleanupForRestart(self.id);
    EXPECT_EQ(messages.take(), "");
    dExternalThreadingServeMultiThreadedImplementation(self.id, nullptr, nullptr);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dExternalThreadingServeMultiThreadedImplementation()");

    std::atomic<bool> open{false};
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    impl.post(hold, &open, 0, nullptr, 0, wait);
    impl.f->free_call_wait(impl.id, wait);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in free_call_wait()");
    impl.f->reset_call_wait(impl.id, wait);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in reset_call_wait()");
    other.f->free_call_wait(other.id, wait);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in free_call_wait()");
    open = true;
    EXPECT_EQ(impl.await(wait, &kLong), 1);
    impl.f->free_call_wait(impl.id, wait);
    impl.f->free_call_wait(impl.id, nullptr);
    EXPECT_EQ(messages.take(), "");
    impl.f->free_call_wait(impl.id, wait);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in free_call_wait()");
}

int free_everything(void* context, dcallindex_t, dCallReleaseeID)
{
    auto& impl = *static_cast<Implementation*>(context);
    dThreadingFreeThreadPool(impl.pool);
    dThreadingThreadPoolServeMultiThreadedImplementation(impl.pool, impl.id);
    dExternalThreadingServeMultiThreadedImplementation(impl.id, nullptr, nullptr);
    dThreadingImplementationShutdownProcessing(impl.id);
    dThreadingFreeThreadPool(impl.pool);
    dThreadingThreadPoolWaitIdleState(impl.pool);
    dThreadingImplementationCleanupForRestart(impl.id);
    dThreadingFreeImplementation(impl.id);
    return 1;
}

std::atomic<int> g_refused{0};

TEST(Tasks, a_call_cannot_pull_its_own_feet_away)
{
    Implementation impl(2);
    dSetDebugHandler([](int, const char*, va_list) { ++g_refused; });
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    impl.post(free_everything, &impl, 0, nullptr, 0, wait);
    EXPECT_EQ(impl.await(wait, &kLong), 1);
    EXPECT_EQ(g_refused.exchange(0), 7);
    dThreadingThreadPoolWaitIdleState(impl.pool);
    dThreadingImplementationCleanupForRestart(impl.id);
    EXPECT_EQ(g_refused, 0);
    dSetDebugHandler(nullptr);
}

TEST(Tasks, bad_calls_are_refused_and_count_as_failed)
{
    MessageRecorder messages;
    const Implementation impl(1), other(1);
    Log log;
    const std::string refused = "2: Bad argument(s) in post_call()";
    int fault = 0;
    dCallReleaseeID name = reinterpret_cast<dCallReleaseeID>(&log);
    impl.f->post_call(impl.id, &fault, &name, 0, nullptr, nullptr, nullptr, nullptr, 0, nullptr);
    EXPECT_EQ(messages.take(), refused);
    EXPECT_EQ(fault, 1);
    EXPECT_EQ(name, nullptr);
    const dCallWaitID theirs = other.f->alloc_call_wait(other.id);
    impl.post(Log::note, &log, 0, nullptr, 0, theirs);
    EXPECT_EQ(messages.take(), refused);
    const auto parent = impl.post(Log::note, &log, 0, nullptr, 1);
    other.post(Log::note, &log, 0, parent);
    EXPECT_EQ(messages.take(), refused);
    const auto grandparent = impl.post(Log::note, &log, 1, nullptr, 1);
    impl.post(Log::note, &log, 1, grandparent, 1);
    impl.post(Log::note, &log, 1, grandparent, 1);  // it counts on one only
    EXPECT_EQ(messages.take(), refused);
    impl.f->alter_call_dependencies_count(impl.id, grandparent, -1);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in alter_call_dependencies_count()");
    EXPECT_EQ(impl.f->preallocate_resources_for_calls(impl.id, ~std::size_t(0)), 0);
    EXPECT_EQ(impl.f->preallocate_resources_for_calls(impl.id, 1000), 1);
    EXPECT_TRUE(log.order.empty());
}

TEST(Tasks, every_function_of_the_table_refuses_null_and_dead_implementations)
{
    MessageRecorder messages;
    const dThreadingImplementationID dead = dThreadingAllocateMultiThreadedImplementation();
    const dThreadingFunctionsInfo& f = *dThreadingImplementationGetFunctions(dead);
    dThreadingFreeImplementation(dead);
    for (const dThreadingImplementationID id : {dead, dThreadingImplementationID(nullptr)}) {
        int status = 7, fault = 0;
        EXPECT_EQ(dThreadingImplementationGetFunctions(id), nullptr);
        EXPECT_EQ(f.alloc_mutex_group(id, 1, nullptr), nullptr);
        f.free_mutex_group(id, nullptr);
        f.lock_group_mutex(id, nullptr, 0);
        f.unlock_group_mutex(id, nullptr, 0);
        EXPECT_EQ(f.alloc_call_wait(id), nullptr);
        f.reset_call_wait(id, nullptr);
        f.free_call_wait(id, nullptr);
        f.post_call(id, &fault, nullptr, 0, nullptr, nullptr, Log::note, nullptr, 0, nullptr);
        f.alter_call_dependencies_count(id, nullptr, 1);
        f.wait_call(id, &status, nullptr, nullptr, nullptr);
        EXPECT_EQ(f.retrieve_thread_count(id), 0u);
        EXPECT_EQ(f.preallocate_resources_for_calls(id, 1), 0);
        EXPECT_EQ(status, 0);
        EXPECT_EQ(fault, 1);
        dThreadingImplementationShutdownProcessing(id);
        dThreadingImplementationCleanupForRestart(id);
        dExternalThreadingServeMultiThreadedImplementation(id, nullptr, nullptr);
        const std::string all = messages.take();
        EXPECT_EQ(std::count(all.begin(), all.end(), '|') + 1, 16) << all;
    }
    dThreadingFreeImplementation(nullptr);
    dThreadingFreeThreadPool(nullptr);
    EXPECT_EQ(messages.take(), "");
    dThreadingFreeImplementation(dead);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dThreadingFreeImplementation()");
}

TEST(Tasks, mutexes_exclude_and_cannot_block_their_own_thread)
{
    MessageRecorder messages;
    const Implementation impl(0), other(0);
    const char* names[] = {"first", "second"};
    const dMutexGroupID group = impl.f->alloc_mutex_group(impl.id, 2, names);
    ASSERT_NE(group, nullptr);
    long sum = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 5000; ++i) {
                impl.f->lock_group_mutex(impl.id, group, 1);
                ++sum;
                impl.f->unlock_group_mutex(impl.id, group, 1);
            }
        });
    for (std::thread& t : threads) t.join();
    EXPECT_EQ(sum, 20000);
    EXPECT_EQ(messages.take(), "");
    impl.f->lock_group_mutex(impl.id, group, 0);
    impl.f->lock_group_mutex(impl.id, group, 0);
    EXPECT_EQ(messages.take(), "2: The mutex is locked by the calling thread in lock_group_mutex()");
    impl.f->free_mutex_group(impl.id, group);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in free_mutex_group()");
    impl.f->unlock_group_mutex(impl.id, group, 0);
#if !defined(__SANITIZE_THREAD__)  // it reports what the library refuses
    impl.f->unlock_group_mutex(impl.id, group, 0);
    EXPECT_EQ(messages.take(), "2: The mutex is not locked by the calling thread in unlock_group_mutex()");
#endif
    impl.f->lock_group_mutex(impl.id, group, 2);
    other.f->lock_group_mutex(other.id, group, 0);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in lock_group_mutex()|2: Bad argument(s) in lock_group_mutex()");
    impl.f->free_mutex_group(impl.id, group);
    EXPECT_EQ(messages.take(), "");
    impl.f->lock_group_mutex(impl.id, group, 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in lock_group_mutex()");
    EXPECT_EQ(impl.f->alloc_mutex_group(impl.id, 0, nullptr), nullptr);
    EXPECT_EQ(impl.f->alloc_mutex_group(impl.id, ~0u, nullptr), nullptr);
}

// In a process of its own: other tests leave the library open.
TEST(ClosedLibrary, has_no_pools)
{
    MessageRecorder messages;
    EXPECT_EQ(dThreadingAllocateThreadPool(2, 0, 0, nullptr), nullptr);
    EXPECT_EQ(messages.take(), "2: Call dInitODE2 first in dAllocateODEDataForThread()");
}

TEST(Tasks, absurd_pools_are_refused)
{
    MessageRecorder messages;
    dInitODE2(0);
    EXPECT_EQ(dThreadingAllocateThreadPool(0, 0, 0, nullptr), nullptr);
    EXPECT_EQ(dThreadingAllocateThreadPool(~0u, 0, 0, nullptr), nullptr);
    EXPECT_NE(messages.take(), "");
    EXPECT_EQ(dThreadingAllocateThreadPool(2, 1, 0, nullptr), nullptr);
    EXPECT_EQ(dThreadingAllocateThreadPool(2, ~dsizeint(0), 0, nullptr), nullptr);
    dCloseODE();
}

// The n-th allocation fails, for every n that there is.
std::atomic<long> g_left{0};
void* scarce(dsizeint size) { return g_left.fetch_sub(1) > 0 ? std::malloc(size) : nullptr; }
void* scarce_again(void* p, dsizeint, dsizeint size)
{
    return g_left.fetch_sub(1) > 0 ? std::realloc(p, size) : nullptr;
}
void plenty(void* p, dsizeint) { std::free(p); }

TEST(Tasks, a_call_that_finds_no_memory_is_run_at_once_or_counts_as_failed)
{
    for (unsigned kind : kKinds) {
        const Implementation impl(kind);
        MessageRecorder messages;
        Log log;
        const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
        dSetAllocHandler(scarce);
        dSetReallocHandler(scarce_again);
        dSetFreeHandler(plenty);
        g_left = 0;
        // Slots that are left in the pool of the process are used up first: those calls wait for ever.
        std::vector<dCallReleaseeID> kept;
        int fault = 7;
        while (const auto call = impl.post(Log::note, &log, 1, nullptr, 1, wait, &fault))
            kept.push_back(call);
        EXPECT_EQ(messages.take(), "2: out of memory in post_call()");
        EXPECT_EQ(fault, 1);
        EXPECT_NE(impl.post(Log::note, &log, 2), nullptr);
        EXPECT_EQ(log.order, std::vector<int>{2});
        EXPECT_TRUE(log.threads.contains(std::this_thread::get_id()));
        dSetAllocHandler(nullptr);
        dSetReallocHandler(nullptr);
        dSetFreeHandler(nullptr);
        for (const auto call : kept) impl.f->alter_call_dependencies_count(impl.id, call, -1);
        EXPECT_EQ(impl.await(wait, &kLong), 1);
        EXPECT_EQ(log.order.size(), kept.size() + 1);
        EXPECT_EQ(messages.take(), "");
    }
}

// The thread sanitizer cannot follow a fork of a process with threads; Windows and WebAssembly have no forks.
#if !defined(__SANITIZE_THREAD__) && !defined(_WIN32) && !defined(__wasm__)
int count_threads(void* threads, dcallindex_t, dCallReleaseeID)
{
    thread_local bool counted = false;
    if (!counted) ++*static_cast<std::atomic<int>*>(threads);
    counted = true;
    return 1;
}

TEST(Tasks, a_forked_child_does_the_work_of_the_threads_that_it_lacks)
{
    std::atomic<bool> over{false};
    Implementation impl(3);
    const dCallWaitID wait = impl.f->alloc_call_wait(impl.id);
    // Forks must meet locks of the library that are held. Those of the program and of the sanitizer's allocator
    // no child could release: what is busy takes none and asks for no memory.
    std::atomic<int> busy_threads{0};
    const dCallWaitID busy_wait = impl.f->alloc_call_wait(impl.id);
    std::thread busy([&] {
        while (!over) {
            for (int i = 0; i < 5; ++i) impl.post(count_threads, &busy_threads, 0, nullptr, 0, busy_wait);
            impl.await(busy_wait);
            impl.f->reset_call_wait(impl.id, busy_wait);
        }
    });
    while (busy_threads < 3) std::this_thread::yield();  // none is still being born
    for (int round = 0; round < 10; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            alarm(20);  // a child that hangs is a failure
            Log log;
            for (int i = 0; i < 20; ++i) impl.post(Log::note, &log, 0, nullptr, 0, wait);
            bool good = impl.await(wait) == 1 && log.order.size() == 20;
            good = good && impl.f->retrieve_thread_count(impl.id) == 0;
            dThreadingImplementationShutdownProcessing(impl.id);
            dThreadingFreeThreadPool(impl.pool);
            dThreadingImplementationCleanupForRestart(impl.id);
            const auto pool = dThreadingAllocateThreadPool(2, 0, 0, nullptr);
            dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl.id);
            good = good && impl.f->retrieve_thread_count(impl.id) == 2;
            dThreadingImplementationShutdownProcessing(impl.id);
            dThreadingFreeThreadPool(pool);
            _exit(good ? 0 : 1);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    }
    over = true;
    busy.join();
}
#endif

}  // namespace
}  // namespace epode
