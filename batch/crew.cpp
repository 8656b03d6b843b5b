// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See crew.h. A system that gives fewer threads gives a smaller crew.
#include "batch/crew.h"

#include <system_error>

namespace epode::batch {

Crew::Crew(int threads)
{
    try {
        for (int i = 1; i < threads; ++i) helpers_.emplace_back([this, i] { help(i); });
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
