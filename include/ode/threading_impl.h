/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The threading implementations that come with the library, and pools of threads to serve one of them. */
#ifndef _ODE_THREADING_IMPL_H_
#define _ODE_THREADING_IMPL_H_

#include <ode/odeconfig.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter threading_impl Threads for steps

    The threading implementations that come with the library, and pools of threads to serve one of them. A
    program that wants its steps on four threads:

        impl = dThreadingAllocateMultiThreadedImplementation();
        pool = dThreadingAllocateThreadPool(4, 0, dAllocateFlagBasicData, NULL);
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
        dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(impl), impl);

    and at the end, in this order:

        dThreadingImplementationShutdownProcessing(impl);
        dThreadingFreeThreadPool(pool);
        dWorldSetStepThreadingImplementation(world, NULL, NULL);
        dThreadingFreeImplementation(impl);

    In the child of a fork, where the threads do not exist, the thread that steps does the work.

    Arguments:
    - impl: an implementation made by one of the first two functions.
    - pool: a pool of threads.

    Refused: an implementation or pool that is 0 or destroyed (0 is ignored where one is freed);
    [dThreadingFreeImplementation] one that is in use; [dThreadingThreadPoolWait, dThreadingFreeThreadPool]
    waiting for threads that nobody has released; the rest as each function says. */

struct dxThreadingThreadPool;
typedef struct dxThreadingThreadPool* dThreadingThreadPoolID; /**< A pool of threads. */

/* ---- implementations ---- */

/** A new implementation whose calls are run by the thread that waits for them, the last posted first.
    Its thread count is 0 and no thread may serve it. Returns NULL when memory is out. [0.16] */
ODE_API dThreadingImplementationID dThreadingAllocateSelfThreadedImplementation(void);

/** A new implementation whose calls are run by the threads that serve it. While none does, the thread that
    waits for calls runs them, so that a step never waits for ever. Returns NULL when memory is out. [0.16] */
ODE_API dThreadingImplementationID dThreadingAllocateMultiThreadedImplementation(void);

/** The functions of an implementation made by dThreadingAllocateSelfThreadedImplementation or
    dThreadingAllocateMultiThreadedImplementation; static, never freed. [0.16] */
ODE_API const dThreadingFunctionsInfo* dThreadingImplementationGetFunctions(dThreadingImplementationID impl);

/** Let the threads that serve go, after the calls that they are in. Calls that have not started stay. Without
    effect on a self-threaded implementation. Returns at once. [0.16] */
ODE_API void dThreadingImplementationShutdownProcessing(dThreadingImplementationID impl);

/** After a shutdown, and when all threads have left: threads may serve again. Refused while some have not
    left. Without effect on a self-threaded implementation. [0.16] */
ODE_API void dThreadingImplementationCleanupForRestart(dThreadingImplementationID impl);

/** Free an implementation with all its mutex groups and waits. Threads that are still on their way out after
    a shutdown are waited for. Refused while threads serve without having been released, wait, or run a call.
    A world that it is set on is not stepped any more (dWorldStep returns 0) until it gets another or none.
    NULL is ignored. [0.16] */
ODE_API void dThreadingFreeImplementation(dThreadingImplementationID impl);

/* ---- threads of the program ---- */

/** What a thread that begins to serve calls, with the context it was given. */
typedef void(dThreadReadyToServeCallback)(void* callback_context);

/** The calling thread serves a multi-threaded implementation until that is shut down; if it has been already,
    it returns at once. readiness_callback (may be NULL) is called with callback_context when the thread has
    been counted. Refused inside a call of the same implementation. [0.16] */
ODE_API void dExternalThreadingServeMultiThreadedImplementation(
    dThreadingImplementationID impl, dThreadReadyToServeCallback* readiness_callback, void* callback_context);

/* ---- pools ---- */

/** Start thread_count threads, 1 to 1024, which inherit the caller's priority, take no signals, and call
    dAllocateODEDataForThread(ode_data_allocate_flags). stack_size: bytes of stack for each, at least
    PTHREAD_STACK_MIN; less than 64 KiB are made 64 KiB; 0 is the system's default. reserved is not looked at.
    Refused before dInitODE2. Returns NULL on failure. [0.16] */
ODE_API dThreadingThreadPoolID dThreadingAllocateThreadPool(unsigned thread_count, dsizeint stack_size,
                                                            unsigned int ode_data_allocate_flags,
                                                            void* reserved);

/** Let all threads of a pool serve a multi-threaded implementation; returns when they do. A pool serves one
    at a time: one that was shut down is waited for, one that was not makes this call refused. Several pools
    may serve the same implementation. If it has been shut down the threads come back at once. [0.16] */
ODE_API void dThreadingThreadPoolServeMultiThreadedImplementation(dThreadingThreadPoolID pool,
                                                                  dThreadingImplementationID impl);

/** Wait until no thread of the pool serves; at once if none does. Refused if the implementation that they
    serve has not been shut down. [0.16] */
ODE_API void dThreadingThreadPoolWaitIdleState(dThreadingThreadPoolID pool);

/** Wait as dThreadingThreadPoolWaitIdleState does, end the threads and free the pool. Refused while an
    implementation that they serve has not been shut down. NULL is ignored. [0.16] */
ODE_API void dThreadingFreeThreadPool(dThreadingThreadPoolID pool);

#ifdef __cplusplus
}
#endif

#endif
