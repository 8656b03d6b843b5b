// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "own_threads.h"

#include <pthread.h>
#include <stdlib.h>
#include <time.h>

struct own;

struct wait {
    int done;
};

struct call {
    struct call* next;
    struct call* dependent;
    struct wait* wait;
    int* fault;
    dThreadedCallFunction* function;
    void* context;
    dcallindex_t index;
    dsizeint dependencies;
    int failed, returned, started;
};

struct own {
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    pthread_t threads[16];
    unsigned count, running, left;
    int ending;
    struct call *first, *last;
    struct own_counts counts;
};

struct group {
    dmutexindex_t count;
    pthread_mutex_t mutexes[];
};

static struct own* own_of(dThreadingImplementationID impl) { return (struct own*)impl; }

/* ---- calls; all of these with the lock held */

static void make_ready(struct own* own, struct call* call)
{
    call->next = NULL;
    if (own->first)
        own->last->next = call;
    else
        own->first = call;
    own->last = call;
    pthread_cond_signal(&own->work);
}

static void finish(struct own* own, struct call* call)
{
    while (call) {
        struct call* dependent = call->dependent;
        const int failed = call->failed;
        if (call->fault) *call->fault = failed;
        if (call->wait) {
            call->wait->done = 1;
            pthread_cond_broadcast(&own->done);
        }
        free(call);
        --own->left;
        ++own->counts.finished;
        call = NULL;
        if (dependent) {
            dependent->failed |= failed;
            if (--dependent->dependencies == 0) {
                if (dependent->returned)
                    call = dependent;
                else if (!dependent->started)
                    make_ready(own, dependent);
            }
        }
    }
}

static void run(struct own* own, struct call* call)
{
    call->started = 1;
    if (++own->running > own->counts.widest) own->counts.widest = own->running;
    pthread_mutex_unlock(&own->lock);
    const int good = call->function(call->context, call->index, (dCallReleaseeID)call);
    pthread_mutex_lock(&own->lock);
    --own->running;
    call->failed |= !good;
    call->returned = 1;
    if (call->dependencies == 0) finish(own, call);
}

static void* serve(void* argument)
{
    struct own* own = argument;
    pthread_mutex_lock(&own->lock);
    while (!own->ending) {
        struct call* call = own->first;
        if (!call) {
            pthread_cond_wait(&own->work, &own->lock);
            continue;
        }
        own->first = call->next;
        int mine = 0;
        for (unsigned i = 0; i < own->count; ++i) mine |= pthread_equal(own->threads[i], pthread_self()) != 0;
        own->counts.on_waiters += !mine;
        run(own, call);
    }
    pthread_mutex_unlock(&own->lock);
    return NULL;
}

/* ---- the table */

static dMutexGroupID alloc_group(dThreadingImplementationID impl, dmutexindex_t count, const char* const* names)
{
    (void)names;
    struct group* group = malloc(sizeof *group + count * sizeof(pthread_mutex_t));
    if (!group) return NULL;
    group->count = count;
    for (dmutexindex_t i = 0; i < count; ++i) pthread_mutex_init(group->mutexes + i, NULL);
    __atomic_add_fetch(&own_of(impl)->counts.groups_made, 1, __ATOMIC_RELAXED);
    return (dMutexGroupID)group;
}

static void free_group(dThreadingImplementationID impl, dMutexGroupID id)
{
    struct group* group = (struct group*)id;
    if (!group) return;
    for (dmutexindex_t i = 0; i < group->count; ++i) pthread_mutex_destroy(group->mutexes + i);
    free(group);
    __atomic_add_fetch(&own_of(impl)->counts.groups_freed, 1, __ATOMIC_RELAXED);
}

static void lock_mutex(dThreadingImplementationID impl, dMutexGroupID id, dmutexindex_t index)
{
    pthread_mutex_lock(((struct group*)id)->mutexes + index);
    __atomic_add_fetch(&own_of(impl)->counts.locked, 1, __ATOMIC_RELAXED);
}

static void unlock_mutex(dThreadingImplementationID impl, dMutexGroupID id, dmutexindex_t index)
{
    __atomic_add_fetch(&own_of(impl)->counts.unlocked, 1, __ATOMIC_RELAXED);
    pthread_mutex_unlock(((struct group*)id)->mutexes + index);
}

static dCallWaitID alloc_wait(dThreadingImplementationID impl)
{
    __atomic_add_fetch(&own_of(impl)->counts.waits_made, 1, __ATOMIC_RELAXED);
    return (dCallWaitID)calloc(1, sizeof(struct wait));
}

static void reset_wait(dThreadingImplementationID impl, dCallWaitID wait)
{
    pthread_mutex_lock(&own_of(impl)->lock);
    ((struct wait*)wait)->done = 0;
    pthread_mutex_unlock(&own_of(impl)->lock);
}

static void free_wait(dThreadingImplementationID impl, dCallWaitID wait)
{
    if (!wait) return;
    __atomic_add_fetch(&own_of(impl)->counts.waits_freed, 1, __ATOMIC_RELAXED);
    free(wait);
}

static void post(dThreadingImplementationID impl, int* fault, dCallReleaseeID* name, ddependencycount_t count,
                 dCallReleaseeID dependent, dCallWaitID wait, dThreadedCallFunction* function, void* context,
                 dcallindex_t index, const char* call_name)
{
    (void)call_name;
    struct own* own = own_of(impl);
    struct call* call = calloc(1, sizeof *call);
    if (!call) abort(); /* a test's memory does not run out */
    call->dependent = (struct call*)dependent;
    call->wait = (struct wait*)wait;
    call->fault = fault;
    call->function = function;
    call->context = context;
    call->index = index;
    call->dependencies = count;
    if (name) *name = (dCallReleaseeID)call;
    pthread_mutex_lock(&own->lock);
    ++own->counts.posted;
    ++own->left;
    if (count == 0) make_ready(own, call);
    pthread_mutex_unlock(&own->lock);
}

static void alter(dThreadingImplementationID impl, dCallReleaseeID id, ddependencychange_t change)
{
    struct own* own = own_of(impl);
    struct call* call = (struct call*)id;
    pthread_mutex_lock(&own->lock);
    call->dependencies += (ddependencycount_t)change;
    if (call->dependencies == 0) {
        if (call->returned)
            finish(own, call);
        else if (!call->started)
            make_ready(own, call);
    }
    pthread_mutex_unlock(&own->lock);
}

static void await(dThreadingImplementationID impl, int* status, dCallWaitID id, const dThreadedWaitTime* limit,
                  const char* name)
{
    (void)name;
    struct own* own = own_of(impl);
    struct wait* wait = (struct wait*)id;
    struct timespec until = {0, 0};
    if (limit) {
        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_sec += limit->wait_sec;
        until.tv_nsec += (long)limit->wait_nsec;
        if (until.tv_nsec >= 1000000000) ++until.tv_sec, until.tv_nsec -= 1000000000;
    }
    pthread_mutex_lock(&own->lock);
    ++own->counts.waited;
    int timed_out = 0;
    while (!wait->done && !timed_out) {
        if (limit)
            timed_out = pthread_cond_timedwait(&own->done, &own->lock, &until) != 0;
        else
            pthread_cond_wait(&own->done, &own->lock);
    }
    if (status) *status = wait->done;
    pthread_mutex_unlock(&own->lock);
}

static unsigned thread_count(dThreadingImplementationID impl) { return own_of(impl)->count; }

static int prepare(dThreadingImplementationID impl, ddependencycount_t calls)
{
    (void)calls;
    __atomic_add_fetch(&own_of(impl)->counts.prepared, 1, __ATOMIC_RELAXED);
    return 1;
}

const dThreadingFunctionsInfo* own_functions(void)
{
    static const dThreadingFunctionsInfo table = {
        sizeof table, alloc_group, free_group, lock_mutex, unlock_mutex, alloc_wait, reset_wait,
        free_wait,    post,        alter,      await,      thread_count, prepare};
    return &table;
}

dThreadingImplementationID own_start(unsigned threads)
{
    struct own* own = calloc(1, sizeof *own);
    if (!own) return NULL;
    pthread_mutex_init(&own->lock, NULL);
    pthread_cond_init(&own->work, NULL);
    pthread_cond_init(&own->done, NULL);
    pthread_mutex_lock(&own->lock);
    while (own->count < threads && pthread_create(own->threads + own->count, NULL, serve, own) == 0)
        ++own->count;
    pthread_mutex_unlock(&own->lock);
    return (dThreadingImplementationID)own;
}

struct own_counts own_count(dThreadingImplementationID impl)
{
    struct own* own = own_of(impl);
    pthread_mutex_lock(&own->lock);
    const struct own_counts counts = own->counts;
    pthread_mutex_unlock(&own->lock);
    return counts;
}

unsigned own_stop(dThreadingImplementationID impl)
{
    struct own* own = own_of(impl);
    pthread_mutex_lock(&own->lock);
    own->ending = 1;
    pthread_cond_broadcast(&own->work);
    pthread_mutex_unlock(&own->lock);
    for (unsigned i = 0; i < own->count; ++i) pthread_join(own->threads[i], NULL);
    const unsigned left = own->left;
    pthread_mutex_destroy(&own->lock);
    pthread_cond_destroy(&own->work);
    pthread_cond_destroy(&own->done);
    free(own);
    return left;
}
