/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The contract between a world and a threading implementation: a table of functions that hold mutexes, take
 * calls with dependencies, and wait for them. */
#ifndef _ODE_THREADING_H_
#define _ODE_THREADING_H_

#include <ode/odeconfig.h>
#include <time.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter threading Threading implementations

    The contract between a world and those who do the work of its steps. Two implementations come with the
    library (@ref threading_impl "threads for steps"); a program that brings threads of its own fills the
    table dThreadingFunctionsInfo and hands it to dWorldSetStepThreadingImplementation or dCooperativeCreate,
    together with a handle of its own choice, which every function gets back as impl.

    A call is done when its function has returned and no calls that it depends on are left; it may add some to
    itself while it runs. What is said of refusals is what the library's own implementations do; the library
    gives a program's implementation no cause for them.

    Refused: as each function says. */

/** A thread limit that limits nothing. */
#define dTHREADING_THREAD_COUNT_UNLIMITED 0U

struct dxThreadingImplementation;
typedef struct dxThreadingImplementation* dThreadingImplementationID; /**< a threading implementation */

/* ---- mutexes, in groups ---- */

typedef unsigned dmutexindex_t; /**< number of a mutex in its group */
struct dxMutexGroup;
typedef struct dxMutexGroup* dMutexGroupID; /**< a group of mutexes */

/** Make Mutex_count mutexes, 1 to 65536, which need not be recursive. Mutex_names_ptr: as many names for
    debugging, or NULL. Returns NULL on failure. */
typedef dMutexGroupID dMutexGroupAllocFunction(dThreadingImplementationID impl, dmutexindex_t Mutex_count,
                                               const char* const* Mutex_names_ptr);

/** Free a group, none of whose mutexes is locked (refused otherwise). NULL is ignored. */
typedef void dMutexGroupFreeFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group);

/** Wait until mutex 0 <= mutex_index < Mutex_count is free, and lock it. Refused if the calling thread has
    locked it already. */
typedef void dMutexGroupMutexLockFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group,
                                          dmutexindex_t mutex_index);

/** Unlock a mutex that the calling thread has locked (refused otherwise). */
typedef void dMutexGroupMutexUnlockFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group,
                                            dmutexindex_t mutex_index);

/* ---- calls ---- */

struct dxCallReleasee;
typedef struct dxCallReleasee* dCallReleaseeID; /**< a call that is not done, as one that others precede */
struct dxCallWait;
typedef struct dxCallWait* dCallWaitID; /**< something a thread can wait on until a call is done */

typedef dsizeint ddependencycount_t;  /**< how many calls must be done first */
typedef ddiffint ddependencychange_t; /**< change of that number */
typedef dsizeint dcallindex_t;        /**< which of several equal calls this is */

/** The work itself. call_context and instance_index are those it was posted with; this_releasee names the
    call, so that it can add dependencies to itself. Returns non-zero on success, 0 for a fault. */
typedef int dThreadedCallFunction(void* call_context, dcallindex_t instance_index,
                                  dCallReleaseeID this_releasee);

/** A span of time: seconds and nanoseconds. */
typedef struct dxThreadedWaitTime {
    time_t wait_sec;         /**< seconds */
    unsigned long wait_nsec; /**< nanoseconds, below 10^9 */
} dThreadedWaitTime;

/** Make something to wait on. Returns NULL on failure. */
typedef dCallWaitID dThreadedCallWaitAllocFunction(dThreadingImplementationID impl);

/** Forget the calls it was posted with, so that it can be used for others. Refused while they are not done or
    a thread waits. */
typedef void dThreadedCallWaitResetFunction(dThreadingImplementationID impl, dCallWaitID call_wait);

/** Free it. Refused while a call that was posted with it is not done, or a thread waits. NULL is ignored. */
typedef void dThreadedCallWaitFreeFunction(dThreadingImplementationID impl, dCallWaitID call_wait);

/** Hand in a call. It starts, on some thread, when dependencies_count calls that name it as their
    dependent_releasee are done; with none it may start before this function returns.
    - out_summary_fault: where 1 is written when the call is done and it, or a call that it depended on,
      directly or not, has returned 0; else 0. May be NULL; must stay valid until the call is done.
    - out_post_releasee: where the name of this call is written, by which others precede it. It is good until
      the call is done. May be NULL.
    - dependent_releasee: the call that this one precedes, or NULL. It must count on one more dependency than
      have been posted for it (refused otherwise).
    - call_wait: told when the call is done, or NULL. Several calls may share one: it then waits for all.
    - call_func, call_context, instance_index: what is called.
    - call_name: for debugging, or NULL; a literal, since it must stay valid.

    A call that is refused, or that there is no memory to keep, counts as done with a fault; where memory is
    out, a call without dependencies is run at once by the thread that posts it. */
typedef void dThreadedCallPostFunction(dThreadingImplementationID impl, int* out_summary_fault,
                                       dCallReleaseeID* out_post_releasee,
                                       ddependencycount_t dependencies_count,
                                       dCallReleaseeID dependent_releasee, dCallWaitID call_wait,
                                       dThreadedCallFunction* call_func, void* call_context,
                                       dcallindex_t instance_index, const char* call_name);

/** Change the number of calls that a call which is not done depends on: before it starts, or by itself while
    it runs. If none are left it starts, or is done if it has returned. Refused below the number of those that
    have been posted for it and are not done. */
typedef void dThreadedCallDependenciesCountAlterFunction(dThreadingImplementationID impl,
                                                         dCallReleaseeID target_releasee,
                                                         ddependencychange_t dependencies_count_change);

/** Wait until all calls that were posted with call_wait are done. timeout_time_ptr: for how long at most (on
    the monotonic clock); zero only asks; NULL for ever. out_wait_status, which may be NULL, is set to 1 if
    they are done and to 0 if not. wait_name is for debugging, or NULL. ODE forbids waiting inside a call,
    since it takes a thread away. Here the waiting thread runs other calls meanwhile, as it does when no
    thread serves. A wait without a limit that nothing can end (nothing was posted; it is that of a call which
    the thread is in) is refused with status 0. */
typedef void dThreadedCallWaitFunction(dThreadingImplementationID impl, int* out_wait_status,
                                       dCallWaitID call_wait, const dThreadedWaitTime* timeout_time_ptr,
                                       const char* wait_name);

/** How many threads serve; 0 says that the thread that waits does the work. */
typedef unsigned dThreadingImplThreadCountRetrieveFunction(dThreadingImplementationID impl);

/** Make room for so many calls at once, at most 65536. Returns 1, or 0 if there is none: then a step that
    asked for it returns 0. */
typedef int dThreadingImplResourcesForCallsPreallocateFunction(
    dThreadingImplementationID impl, ddependencycount_t max_simultaneous_calls_estimate);

/** The table. struct_size: sizeof(dThreadingFunctionsInfo), set by who fills it. No function may be missing.
    A step uses, on the thread that calls it: retrieve_thread_count, preallocate_resources_for_calls,
    alloc_call_wait; for each of its parallel parts reset_call_wait, post_call, wait_call; free_call_wait. */
typedef struct dxThreadingFunctionsInfo {
    unsigned struct_size;                               /**< sizeof(dThreadingFunctionsInfo) */
    dMutexGroupAllocFunction* alloc_mutex_group;        /**< makes mutexes */
    dMutexGroupFreeFunction* free_mutex_group;          /**< frees them */
    dMutexGroupMutexLockFunction* lock_group_mutex;     /**< locks one */
    dMutexGroupMutexUnlockFunction* unlock_group_mutex; /**< unlocks one */
    dThreadedCallWaitAllocFunction* alloc_call_wait;    /**< makes something to wait on */
    dThreadedCallWaitResetFunction* reset_call_wait;    /**< makes it fit for another use */
    dThreadedCallWaitFreeFunction* free_call_wait;      /**< frees it */
    dThreadedCallPostFunction* post_call;               /**< takes a call */
    dThreadedCallDependenciesCountAlterFunction*
        alter_call_dependencies_count;    /**< changes how many calls come first */
    dThreadedCallWaitFunction* wait_call; /**< waits */
    dThreadingImplThreadCountRetrieveFunction* retrieve_thread_count; /**< tells how many threads serve */
    dThreadingImplResourcesForCallsPreallocateFunction* preallocate_resources_for_calls; /**< makes room */
} dThreadingFunctionsInfo;

#ifdef __cplusplus
}
#endif

#endif
