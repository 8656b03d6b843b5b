// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contract between a world and a threading implementation: a table of functions that can hold
// mutexes, take calls with dependencies, and wait for them. Only the types; a program that brings its own
// thread pool fills dThreadingFunctionsInfo.
#ifndef _ODE_THREADING_H_
#define _ODE_THREADING_H_

#include <ode/odeconfig.h>
#include <time.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A thread limit that limits nothing. */
#define dTHREADING_THREAD_COUNT_UNLIMITED 0U

struct dxThreadingImplementation;
typedef struct dxThreadingImplementation* dThreadingImplementationID; /**< a threading implementation */

/* ---- mutexes, in groups ---- */

typedef unsigned dmutexindex_t; /**< number of a mutex in its group */
struct dxMutexGroup;
typedef struct dxMutexGroup* dMutexGroupID; /**< a group of mutexes */

/** Make Mutex_count mutexes; the names (may be NULL) are for debugging. NULL on failure. */
typedef dMutexGroupID dMutexGroupAllocFunction(dThreadingImplementationID impl, dmutexindex_t Mutex_count,
                                               const char* const* Mutex_names_ptr);
typedef void dMutexGroupFreeFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group);
typedef void dMutexGroupMutexLockFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group,
                                          dmutexindex_t mutex_index);
typedef void dMutexGroupMutexUnlockFunction(dThreadingImplementationID impl, dMutexGroupID mutex_group,
                                            dmutexindex_t mutex_index);

/* ---- calls ---- */

struct dxCallReleasee;
typedef struct dxCallReleasee* dCallReleaseeID; /**< a call that waits for others */
struct dxCallWait;
typedef struct dxCallWait* dCallWaitID; /**< something a thread can wait on until a call is done */

typedef dsizeint ddependencycount_t;  /**< how many calls must finish first */
typedef ddiffint ddependencychange_t; /**< change of that number */
typedef dsizeint dcallindex_t;        /**< which of several equal calls this is */

/** The work itself. Returns non-zero on success. */
typedef int dThreadedCallFunction(void* call_context, dcallindex_t instance_index,
                                  dCallReleaseeID this_releasee);

/** A span of time: seconds and nanoseconds. */
typedef struct dxThreadedWaitTime {
    time_t wait_sec;         /**< seconds */
    unsigned long wait_nsec; /**< nanoseconds, below 10^9 */
} dThreadedWaitTime;

typedef dCallWaitID dThreadedCallWaitAllocFunction(dThreadingImplementationID impl);
typedef void dThreadedCallWaitResetFunction(dThreadingImplementationID impl, dCallWaitID call_wait);
typedef void dThreadedCallWaitFreeFunction(dThreadingImplementationID impl, dCallWaitID call_wait);

/** Hand in a call. It starts when dependencies_count calls naming it as their dependent have
    finished. out_summary_fault, out_post_releasee, dependent_releasee, call_wait, call_name may be NULL. */
typedef void dThreadedCallPostFunction(dThreadingImplementationID impl, int* out_summary_fault,
                                       dCallReleaseeID* out_post_releasee,
                                       ddependencycount_t dependencies_count,
                                       dCallReleaseeID dependent_releasee, dCallWaitID call_wait,
                                       dThreadedCallFunction* call_func, void* call_context,
                                       dcallindex_t instance_index, const char* call_name);

/** Add to the number of calls a waiting call depends on. */
typedef void dThreadedCallDependenciesCountAlterFunction(dThreadingImplementationID impl,
                                                         dCallReleaseeID target_releasee,
                                                         ddependencychange_t dependencies_count_change);

/** Wait for a call. timeout_time_ptr NULL: for ever. out_wait_status (may be NULL): 1 done, 0 timed out. */
typedef void dThreadedCallWaitFunction(dThreadingImplementationID impl, int* out_wait_status,
                                       dCallWaitID call_wait, const dThreadedWaitTime* timeout_time_ptr,
                                       const char* wait_name);

/** How many threads serve. */
typedef unsigned dThreadingImplThreadCountRetrieveFunction(dThreadingImplementationID impl);

/** Make room for so many calls at once. Returns non-zero on success. */
typedef int dThreadingImplResourcesForCallsPreallocateFunction(
    dThreadingImplementationID impl, ddependencycount_t max_simultaneous_calls_estimate);

/** The table. struct_size: sizeof(dThreadingFunctionsInfo), set by who fills it. */
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
