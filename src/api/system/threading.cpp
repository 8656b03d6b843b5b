// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The threading implementations and pools of threads that the library offers to programs
// (ode/threading_impl.h).
#include "tasks/threading.h"

#include "base/check.h"
#include "base/objects/pool.h"
#include "ode/odeinit.h"
#include "tasks/serving_pool.h"

using namespace epode;

namespace {

dThreadingImplementationID make(bool served, const char* caller = __builtin_FUNCTION())
{
    const Threading* const made = Pool<Threading>::create(served);
    if (!made) refuse_for(caller, kOutOfMemory);
    return to_handle(made);
}

constexpr const char* kServing = "Threads serve that have not been released by a shutdown";

}  // namespace

#define IMPLEMENTATION_OR(...)                           \
    Threading* const own = from_handle<Threading>(impl); \
    EPODE_USER(own __VA_OPT__(, ) __VA_ARGS__)

#define POOL_OR()                                          \
    ServingPool* const own = from_handle<ServingPool>(id); \
    EPODE_USER(own)

extern "C" {

dThreadingImplementationID dThreadingAllocateSelfThreadedImplementation() { return make(false); }

dThreadingImplementationID dThreadingAllocateMultiThreadedImplementation() { return make(true); }

const dThreadingFunctionsInfo* dThreadingImplementationGetFunctions(dThreadingImplementationID impl)
{
    IMPLEMENTATION_OR(nullptr);
    return &threading_functions();
}

void dThreadingImplementationShutdownProcessing(dThreadingImplementationID impl)
{
    IMPLEMENTATION_OR();
    if (own->served) own->calls.close();
}

void dThreadingImplementationCleanupForRestart(dThreadingImplementationID impl)
{
    IMPLEMENTATION_OR();
    EPODE_USER_SAY(!own->served || own->calls.reopen(), "Threads are still on their way out");
}

void dThreadingFreeImplementation(dThreadingImplementationID impl)
{
    if (!impl) return;
    IMPLEMENTATION_OR();
    EPODE_USER_SAY(own->calls.may_end(), "Threads serve, wait or run calls");
    Pool<Threading>::destroy(own);
}

void dExternalThreadingServeMultiThreadedImplementation(dThreadingImplementationID impl,
                                                        dThreadReadyToServeCallback* ready, void* context)
{
    IMPLEMENTATION_OR();
    EPODE_USER(own->served);
    EPODE_USER_SAY(own->calls.serve({ready, nullptr, context}), "The thread is in a call already");
}

dThreadingThreadPoolID dThreadingAllocateThreadPool(unsigned thread_count, dsizeint stack_size,
                                                    unsigned int ode_data_allocate_flags, void*)
{
    EPODE_USER(thread_count > 0 && thread_count <= ServingPool::kMaxThreads, nullptr);
    if (!dAllocateODEDataForThread(ode_data_allocate_flags)) return nullptr;
    const ServingPool* const pool =
        ServingPool::create({thread_count, stack_size, dAllocateODEDataForThread, ode_data_allocate_flags});
    EPODE_USER_SAY(pool, "out of memory or of threads", nullptr);
    return to_handle(pool);
}

void dThreadingThreadPoolServeMultiThreadedImplementation(dThreadingThreadPoolID id,
                                                          dThreadingImplementationID impl)
{
    POOL_OR();
    Threading* const threading = from_handle<Threading>(impl);
    EPODE_USER(threading && threading->served);
    EPODE_USER_SAY(own->serve(threading->calls), kServing);
}

void dThreadingThreadPoolWaitIdleState(dThreadingThreadPoolID id)
{
    POOL_OR();
    EPODE_USER_SAY(own->wait_until_idle(), kServing);
}

void dThreadingFreeThreadPool(dThreadingThreadPoolID id)
{
    if (!id) return;
    POOL_OR();
    EPODE_USER_SAY(ServingPool::destroy(own), kServing);
}

}  // extern "C"
