// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Behind dThreadingThreadPoolID: threads that wait for an order to serve a queue of calls, serve it until it
// is closed, and wait again. A pool serves one queue at a time. Waiting for threads that have no order to
// leave is refused, because the thread that could give the order may be the one that waits.
#pragma once

#include "base/objects/handle.h"
#include "base/threads/system_threads.h"
#include "ode/threading_impl.h"
#include "tasks/call_queue.h"

namespace epode {

struct PoolSettings {
    unsigned threads;
    std::size_t stack;       // bytes; 0: the system's default
    int (*start)(unsigned);  // called by every thread first; 0 is failure
    unsigned flags;          // for it
};

class ServingPool : public Tagged {
  public:
    static constexpr unsigned kMaxThreads = 1024;

    // Null when memory, the system or a thread's start fails; all threads have started otherwise.
    static ServingPool* create(const PoolSettings& settings);
    // False: the threads serve and have not been released, or the caller is one of them.
    static bool destroy(ServingPool* pool);

    explicit ServingPool(const PoolSettings& settings);
    ~ServingPool();

    // Returns when all threads serve. False: they serve another queue, or the caller is one of them.
    bool serve(CallQueue& queue);
    bool wait_until_idle();  // false: as destroy

  private:
    static void* main_of(void* pool);
    bool start();
    bool spawn();
    void live();
    void work(CallQueue& queue);
    bool wait_until_left();
    void stop();
    void act(ForkStage stage);

    const PoolSettings settings_;
    Lock lock_;
    Condition orders_, news_;  // orders to the threads; reports from them
    pthread_t* threads_ = nullptr;
    unsigned count_ = 0;  // that were created
    unsigned started_ = 0, failed_ = 0;
    CallQueue* queue_ = nullptr;
    unsigned order_ = 0;  // grows with every queue to serve
    unsigned ready_ = 0;  // threads that serve it
    unsigned busy_ = 0;   // threads that have not left it
    bool ending_ = false;
    ForkWatch watch_;
};
template <>
struct HandleOf<ServingPool> {
    using Id = dThreadingThreadPoolID;
    static constexpr Tag kTag = Tag::kThreadPool;
};

}  // namespace epode
