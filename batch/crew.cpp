// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See crew.h. A system that gives fewer threads gives a smaller crew.
#include "batch/crew.h"

#include <algorithm>
#include <system_error>

#ifdef __linux__
#include <sched.h>
#endif

namespace epode::batch {

namespace {

#ifdef __linux__
// To the number-th processor that may be used, counted round; a system that refuses leaves it anywhere.
void pin(std::thread& thread, int number)
{
    cpu_set_t usable, its;
    if (sched_getaffinity(0, sizeof usable, &usable) != 0) return;
    int left = number % std::max(1, CPU_COUNT(&usable)), cpu = 0;
    while (cpu < CPU_SETSIZE && (!CPU_ISSET(cpu, &usable) || left-- > 0)) ++cpu;
    CPU_ZERO(&its);
    CPU_SET(cpu, &its);
    pthread_setaffinity_np(thread.native_handle(), sizeof its, &its);
}
#else
void pin(std::thread&, int) {}
#endif

}  // namespace

Crew::Crew(int threads, bool is_pinned)
{
    try {
        for (int i = 1; i < threads; ++i) {
            helpers_.emplace_back([this, i] { help(i); });
            if (is_pinned) pin(helpers_.back(), i);
        }
    } catch (const std::system_error&) {}
}

Crew::~Crew()
{
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    begun_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

void Crew::take_pieces(int worker)
{
    for (int piece; (piece = next_.fetch_add(1)) < pieces_;) (*do_piece_)(piece, worker);
}

void Crew::help(int worker)
{
    for (int seen = 0;;) {
        std::unique_lock lock(mutex_);
        begun_.wait(lock, [&] { return ends_ || round_ != seen; });
        if (ends_) return;
        seen = round_;
        lock.unlock();
        take_pieces(worker);
        lock.lock();
        if (--busy_ == 0) done_.notify_one();
    }
}

void Crew::work(int pieces, const std::function<void(int, int)>& do_piece)
{
    std::unique_lock lock(mutex_);
    do_piece_ = &do_piece, pieces_ = pieces, next_ = 0;
    busy_ = int(helpers_.size()), ++round_;
    lock.unlock();
    begun_.notify_all();
    take_pieces(0);
    lock.lock();
    done_.wait(lock, [&] { return busy_ == 0; });
}

}  // namespace epode::batch
