// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A job lives until its last call has arrived, which is usually before the wait ends. (Calls that an
// implementation loses keep theirs alive: a few dozen bytes each time.)
#include "tasks/posting.h"

#include <algorithm>
#include <atomic>

#include "base/float_environment.h"
#include "base/objects/pool.h"
#include "base/threads/spin.h"
#include "tasks/worker.h"

namespace epode {
namespace {

struct Job : Tagged {
    Job(Posting::Piece p, void* b, int n, int users)
        : Tagged(Tag::kPostedJob), piece(p), body(b), count(n), references(users)
    {}

    void work(int worker)
    {
        const AsWorker mark(worker);
        int index;
        while ((index = next.fetch_add(1, std::memory_order_relaxed)) < count) {
            piece(body, index, worker);
            done.fetch_add(1, std::memory_order_release);
        }
    }

    void leave()
    {
        if (references.fetch_sub(1, std::memory_order_acq_rel) == 1) Pool<Job>::destroy(this);
    }

    const Posting::Piece piece;
    void* const body;
    const int count;
    std::atomic<int> next{0}, done{0};
    std::atomic<int> references;  // calls to come, and the thread that posts them
};

int take_part(void* context, dcallindex_t index, dCallReleaseeID)
{
    const FloatEnvironment floats;
    Job& job = *static_cast<Job*>(context);
    job.work(int(index) + 1);
    job.leave();
    return 1;
}

int nothing(void*, dcallindex_t, dCallReleaseeID) { return 1; }

}  // namespace

bool Posting::open(const dThreadingFunctionsInfo& functions, dThreadingImplementationID impl, unsigned limit)
{
    const CallerFloatEnvironment program;
    functions_ = functions;
    impl_ = impl;
    measure(limit);
    if (!functions_.preallocate_resources_for_calls(impl, ddependencycount_t(width_) + 1)) return false;
    wait_ = functions_.alloc_call_wait(impl);
    return wait_;
}

void Posting::measure(unsigned limit)
{
    const CallerFloatEnvironment program;
    const unsigned threads = std::clamp(functions_.retrieve_thread_count(impl_), 1u, unsigned(kMaxCalls));
    width_ = int(limit ? std::min(threads, limit) : threads);
}

void Posting::close()
{
    const CallerFloatEnvironment program;
    if (wait_) functions_.free_call_wait(impl_, wait_);
    wait_ = nullptr;
}

void Posting::post_and_wait(int calls, void* job) const
{
    const CallerFloatEnvironment program;
    dCallReleaseeID all = nullptr;
    functions_.reset_call_wait(impl_, wait_);
    if (calls > 1)
        functions_.post_call(impl_, nullptr, &all, ddependencycount_t(calls), nullptr, wait_, nothing,
                             nullptr, 0, "step: all parts done");
    for (int i = 0; i < calls; ++i)
        functions_.post_call(impl_, nullptr, nullptr, 0, all, calls > 1 ? nullptr : wait_, take_part, job,
                             dcallindex_t(i), "step: part");
    functions_.wait_call(impl_, nullptr, wait_, nullptr, "step");
}

void Posting::run(int calls, int count, Piece piece, void* body) const
{
    calls = std::min({calls, count, width_});
    Job* const job = calls > 0 ? Pool<Job>::create(piece, body, count, calls + 1) : nullptr;
    if (!job) {
        for (int i = 0; i < count; ++i) piece(body, i, 0);
        return;
    }
    post_and_wait(calls, job);
    job->work(0);
    while (job->done.load(std::memory_order_acquire) < count) yield_core();
    job->leave();
}

}  // namespace epode
