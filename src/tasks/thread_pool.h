// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The threads behind Tasks: one pool for the process, because worlds that step at the same time share the
// same cores. A step that finds the pool in use works alone: slower, with the same result. So does a step
// when helpers lose their cores to other processes and cost more than they contribute (help_balance.h).
#pragma once

#include <atomic>

#include "base/threads/system_threads.h"
#include "tasks/help_balance.h"

namespace epode {

class ThreadPool {
  public:
    using Piece = void (*)(void* body, int index, int worker);
    static constexpr int kMaxThreads = 64;

    // The caller becomes worker 0 of at most `workers`. False: the pool is in use or rests, and nothing was
    // run.
    bool run(int workers, int count, Piece piece, void* body);

    // A hint, for any thread at any time: a job now would run nothing.
    bool refuses() const;

    // Ends all threads; the next run starts new ones.
    void stop();

    // For the child of a fork, which has none of the threads.
    void forget_threads();

  private:
    struct Thread {
        ThreadPool* pool;
        int worker;
        pthread_t id;
    };
    static void* main_of(void* thread);
    void run_with_helpers(int workers, int count, Piece piece, void* body);
    void start_up_to(int threads);
    void serve(int worker);
    void work(int worker);
    unsigned wait_for_news(unsigned seen);

    // A job. A late worker may read its fields while the next job is being written; it does not use them,
    // because the ticket is closed meanwhile.
    std::atomic<Piece> piece_{nullptr};
    std::atomic<void*> body_{nullptr};
    std::atomic<int> count_{0};
    std::atomic<int> workers_{0};
    static constexpr int kClosed = 0x7fffffff;
    std::atomic<unsigned long long> ticket_{kClosed};  // job number << 32 | next index
    std::atomic<int> done_{0};

    std::atomic<unsigned> news_{0};  // grows with every job and at the end
    std::atomic<bool> ending_{false};
    std::atomic_flag taken_ = ATOMIC_FLAG_INIT;
    HelpBalance balance_;                  // of the caller that has taken the pool
    std::atomic<unsigned> lost_cores_{0};  // by helpers, in a job or while they wait for the next
    Thread threads_[kMaxThreads] = {};
    int thread_count_ = 0;
};

ThreadPool& thread_pool();

}  // namespace epode
