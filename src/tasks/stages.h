// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Work in stages on several cores: the pieces of one stage are independent, and no piece begins before all
// pieces of the stage before are done. One job of Tasks per stage would do the same, but a step in substeps
// has a hundred stages of a few microseconds. Here all stages are one job, whose workers stay in it from
// stage to stage.
//
//   home     Each worker begins with its own share of the pieces, the same share in every stage: what it
//            wrote before is still in its cache, and no other worker competes for the claim. When the others
//            take longer than a moment, it helps them; looking at their tickets earlier would delay them.
//   done     Once per stage a worker reports how many pieces it has done; the worker that completes the stage
//            opens the next one. Both are in one word, so a hand-over moves one line from cache to cache.
//   waiting  No worker waits for one that has not arrived: those present do all pieces. A worker that is
//            alone does not even grant the others that moment.
#pragma once

#include <atomic>

#include "base/config.h"
#include "base/threads/spin.h"
#include "tasks/tasks.h"
#include "tasks/waiting.h"

namespace epode {

// `pieces(stage)`: the number of pieces; all workers call it, so it must always return the same. Runs
// `body(stage, index, worker)`.
template <typename Pieces, typename Body>
class Stages {
  public:
    Stages(int stages, int shares, const Pieces& pieces, const Body& body)
        : stages_(stages), shares_(shares < kMaxShares ? shares : kMaxShares), pieces_(pieces), body_(body)
    {
        open(0);
    }

    // The work of one worker; when it returns, all remaining pieces are in the hands of others.
    void serve(int worker)
    {
        const int home = worker % shares_;
        come_.fetch_add(1, std::memory_order_relaxed);
        Waiting waiting;
        for (int last = -1, patience = 0;;) {
            const int stage = int(state_.load(std::memory_order_acquire) >> 32);
            if (stage >= stages_) return;
            if (stage != last) {
                waiting.end();
                last = stage;
                patience = come_.load(std::memory_order_relaxed) > 1 ? kPatience : 1;
                report(stage, take_from(home, stage, worker));
            } else if (patience > 0) {
                if (--patience == 0)
                    report(stage, take_from_others(home, stage, worker));
                else
                    spin_once();
            } else {
                waiting.once();
            }
        }
    }

  private:
    static constexpr int kMaxShares = 64;
    static constexpr int kPatience = 30;  // spins, about a microsecond
    using Ticket = unsigned long long;    // stage << 32 | next piece; of an earlier stage: none taken yet
    struct alignas(kCacheLine) Share {
        std::atomic<Ticket> ticket{Ticket(0xffffffffu) << 32};
    };

    // All earlier stages are done, so a share with untaken pieces belongs to this stage: a ticket read in an
    // earlier stage has changed since.
    int take_from(int share, int stage, int worker)
    {
        const int count = pieces_(stage);
        const int begin = int((long long)count * share / shares_);
        const int end = int((long long)count * (share + 1) / shares_);
        int done = 0;
        for (Ticket seen = share_[share].ticket.load(std::memory_order_acquire);;) {
            const int begun = int(seen >> 32);
            const int next = begun == stage ? int(seen & 0xffffffffu) : begin;
            if (next >= end || begun > stage) return done;
            const Ticket taken = Ticket(stage) << 32 | Ticket(next + 1);
            if (!share_[share].ticket.compare_exchange_weak(seen, taken, std::memory_order_acq_rel)) continue;
            seen = taken;
            body_(stage, next, worker);
            ++done;
        }
    }

    int take_from_others(int home, int stage, int worker)
    {
        int done = 0;
        for (int i = 1; i < shares_; ++i) done += take_from((home + i) % shares_, stage, worker);
        return done;
    }

    void report(int stage, int done)
    {
        if (done == 0) return;
        const State before = state_.fetch_add(State(done), std::memory_order_acq_rel);
        if (int(before & 0xffffffffu) + done == pieces_(stage)) open(stage + 1);
    }

    // Stages without pieces are skipped.
    void open(int stage)
    {
        while (stage < stages_ && pieces_(stage) <= 0) ++stage;
        state_.store(State(unsigned(stage)) << 32, std::memory_order_release);
    }

    const int stages_, shares_;
    const Pieces& pieces_;
    const Body& body_;
    using State = unsigned long long;  // stage << 32 | pieces of it that are done
    alignas(kCacheLine) std::atomic<State> state_{0};
    std::atomic<int> come_{0};  // workers
    Share share_[kMaxShares];
};

template <typename Pieces, typename Body>
void in_stages(const Tasks& tasks, int stages, const Pieces& pieces, const Body& body)
{
    Stages<Pieces, Body> job(stages, tasks.workers(), pieces, body);
    tasks.for_each(tasks.workers(), [&](int, int worker) { job.serve(worker); });
}

}  // namespace epode
