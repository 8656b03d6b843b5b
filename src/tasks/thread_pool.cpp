// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pieces are claimed one by one by compare-and-swap on a ticket that carries the number of the job, so a
// worker that wakes late can never take a piece of the next job by the old count. A step has many short
// stages: workers spin for a while before they sleep, and the caller spins, then yields, while it waits for
// the last piece. Plain pthreads, because starting a std::thread can fail only by exception.
#include "tasks/thread_pool.h"

#include <new>

#include "base/float_environment.h"
#include "base/objects/lifecycle.h"
#include "base/threads/address_wait.h"
#include "base/threads/spin.h"
#include "tasks/operating_system.h"
#include "tasks/tasks.h"
#include "tasks/waiting.h"
#include "tasks/worker.h"

namespace epode {
namespace {

constexpr int kPoolSpins = 4000;  // some ten microseconds
constexpr std::size_t kStack = 512 * 1024;

// Under the thread sanitizer the helpers are what is tested, and its slowness looks like lost cores.
#ifdef __SANITIZE_THREAD__
constexpr bool kAlwaysHelped = true;
#else
constexpr bool kAlwaysHelped = false;
#endif

}  // namespace

constinit thread_local int t_worker = -1;

constinit thread_local long long t_waited = 0;

bool ThreadPool::refuses() const
{
    return taken_.test(std::memory_order_relaxed) || !(kAlwaysHelped || balance_.worth(nanoseconds_now()));
}

bool ThreadPool::run(int workers, int count, Piece piece, void* body)
{
    if (t_worker >= 0 || taken_.test_and_set(std::memory_order_acquire)) return false;
    const long long begin = nanoseconds_now(), before = t_waited;
    const bool worth = kAlwaysHelped || balance_.worth(begin);
    if (worth) {
        run_with_helpers(workers, count, piece, body);
        balance_.note(begin, nanoseconds_now(), t_waited - before,
                      lost_cores_.load(std::memory_order_relaxed));
    }
    taken_.clear(std::memory_order_release);
    return worth;
}

void ThreadPool::run_with_helpers(int workers, int count, Piece piece, void* body)
{
    start_up_to((workers < count ? workers : count) - 1);
    piece_.store(piece, std::memory_order_relaxed);
    body_.store(body, std::memory_order_relaxed);
    count_.store(count, std::memory_order_relaxed);
    workers_.store(workers, std::memory_order_relaxed);
    done_.store(0, std::memory_order_relaxed);
    const unsigned job = news_.load(std::memory_order_relaxed) + 1;
    ticket_.store((unsigned long long)job << 32, std::memory_order_release);
    news_.store(job, std::memory_order_release);
    wake_waiting(news_);

    work(0);
    for (Waiting waiting; done_.load(std::memory_order_acquire) < count;) waiting.once();
    ticket_.store((unsigned long long)job << 32 | kClosed, std::memory_order_release);
}

void ThreadPool::work(int worker)
{
    const AsWorker mark(worker);
    for (;;) {
        unsigned long long ticket = ticket_.load(std::memory_order_acquire);
        const int index = int(ticket & 0xffffffffu);
        if (index >= count_.load(std::memory_order_relaxed)) break;
        if (worker >= workers_.load(std::memory_order_relaxed)) break;
        const Piece piece = piece_.load(std::memory_order_relaxed);
        void* const body = body_.load(std::memory_order_relaxed);
        if (!ticket_.compare_exchange_strong(ticket, ticket + 1, std::memory_order_acq_rel)) continue;
        piece(body, index, worker);
        done_.fetch_add(1, std::memory_order_release);
    }
}

unsigned ThreadPool::wait_for_news(unsigned seen)
{
    for (int spins = 0; spins < kPoolSpins; ++spins) {
        const unsigned news = news_.load(std::memory_order_acquire);
        if (news != seen) return news;
        spin_once();
    }
    wait_while(news_, seen);
    return news_.load(std::memory_order_acquire);
}

void ThreadPool::serve(int worker)
{
    // A job may have been posted before this thread started: look for it first.
    unsigned seen = 0;
    for (long lost = 0; !ending_.load(std::memory_order_acquire); seen = wait_for_news(seen)) {
        work(worker);
        const long now = times_unseated();
        if (now != lost) lost_cores_.fetch_add(1, std::memory_order_relaxed);
        lost = now;
    }
}

void* ThreadPool::main_of(void* argument)
{
    const FloatEnvironment floats;
    Thread& self = *static_cast<Thread*>(argument);
    self.pool->serve(self.worker);
    return nullptr;
}

// If the system refuses a thread, the existing ones do the work.
void ThreadPool::start_up_to(int threads)
{
    if (threads > kMaxThreads) threads = kMaxThreads;
    if (thread_count_ >= threads) return;
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return;
    pthread_attr_setstacksize(&attributes, kStack);
    while (thread_count_ < threads) {
        Thread& next = threads_[thread_count_];
        next = {this, thread_count_ + 1, {}};
        if (pthread_create(&next.id, &attributes, main_of, &next) != 0) break;
        ++thread_count_;
    }
    pthread_attr_destroy(&attributes);
}

void ThreadPool::stop()
{
    while (taken_.test_and_set(std::memory_order_acquire)) yield_core();
    ending_.store(true, std::memory_order_release);
    news_.fetch_add(1, std::memory_order_acq_rel);
    wake_waiting(news_);
    for (int i = 0; i < thread_count_; ++i) pthread_join(threads_[i].id, nullptr);
    thread_count_ = 0;
    ending_.store(false, std::memory_order_release);
    taken_.clear(std::memory_order_release);
}

void ThreadPool::forget_threads()
{
    thread_count_ = 0;
    ticket_.store(kClosed, std::memory_order_relaxed);
    taken_.clear(std::memory_order_relaxed);
    t_worker = -1;
}

// Never destroyed: threads may still wait in it when the process ends.
ThreadPool& thread_pool()
{
    alignas(ThreadPool) static unsigned char memory[sizeof(ThreadPool)];
    static ThreadPool* const pool = [] {
        auto* made = new (memory) ThreadPool;
        (void)on_last_close([] { thread_pool().stop(); });
        at_fork(nullptr, nullptr, [] { thread_pool().forget_threads(); });
        return made;
    }();
    return *pool;
}

void Tasks::run(int count, Piece piece, void* body) const
{
    if (posting_ && t_worker < 0) return posting_->run(workers_ - 1, count, piece, body);
    if (!posting_ && thread_pool().run(workers_, count, piece, body)) return;
    // The pool is in use or rests, or this is a job inside a piece.
    const int self = t_worker >= 0 && t_worker < workers_ ? t_worker : 0;
    const AsWorker mark(self);
    for (int i = 0; i < count; ++i) piece(body, i, self);
}

bool Tasks::alone() const { return workers_ == 1 || t_worker >= 0 || (!posting_ && thread_pool().refuses()); }

int processor_count()
{
    const unsigned n = system_processors();
    return n < 1 ? 1 : n > unsigned(ThreadPool::kMaxThreads) ? ThreadPool::kMaxThreads : int(n);
}

}  // namespace epode
