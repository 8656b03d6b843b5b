// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Work in stages on several cores: pieces of one stage know nothing of each other, and none of them is begun
// before all of the stage before are done. A job of Tasks for every stage would do the same, but small steps
// are a hundred stages of a few microseconds: here all are one job, whose workers stay in it from stage to
// stage.
//   home     Each worker begins with the pieces of its own share, the same share in every stage: what it
//            wrote is still in its cache, and claiming them is nobody else's business. Then it helps others.
//   done     A worker tells once a stage how many pieces it has done, when it finds no more; who tells the
//            last one opens the next stage.
//   waiting  Nobody waits for one who has not come: whoever is there does all pieces.
#pragma once

#include <atomic>

#include "base/config.h"
#include "tasks/tasks.h"
#include "tasks/waiting.h"

namespace epode {

// `pieces(stage)`: how many; asked by all workers, so always the same. `body(stage, index, worker)`.
template <typename Pieces, typename Body>
class Stages {
  public:
    Stages(int stages, int shares, const Pieces& pieces, const Body& body)
        : stages_(stages), shares_(shares < kMostShares ? shares : kMostShares), pieces_(pieces), body_(body)
    {
        open(0);
    }

    // What a worker does; when it returns, all that is left is with others.
    void serve(int worker)
    {
        const int home = worker % shares_;
        int last = -1;
        for (Waiting waiting;;) {
            const int stage = stage_.load(std::memory_order_acquire);
            if (stage >= stages_) return;
            if (stage == last) {
                waiting.once();
                continue;
            }
            waiting.end();
            last = stage;
            const int count = pieces_(stage);
            int done = 0;
            for (int i = 0; i < shares_; ++i) done += take_from((home + i) % shares_, stage, count, worker);
            if (done > 0 && done_.fetch_add(done, std::memory_order_acq_rel) + done == count) open(stage + 1);
        }
    }

  private:
    static constexpr int kMostShares = 64;
    using Ticket = unsigned long long;  // stage << 32 | next piece; of an earlier stage: none taken yet
    struct alignas(kCacheLine) Share {
        std::atomic<Ticket> ticket{Ticket(0xffffffffu) << 32};
    };

    // All stages before are done, so a share whose pieces are not all taken belongs to this one: a ticket
    // that was read in an earlier stage has changed since.
    int take_from(int share, int stage, int count, int worker)
    {
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

    // Stages without pieces are none.
    void open(int stage)
    {
        while (stage < stages_ && pieces_(stage) <= 0) ++stage;
        done_.store(0, std::memory_order_relaxed);
        stage_.store(stage, std::memory_order_release);
    }

    const int stages_, shares_;
    const Pieces& pieces_;
    const Body& body_;
    alignas(kCacheLine) std::atomic<int> stage_{0};
    alignas(kCacheLine) std::atomic<int> done_{0};
    Share share_[kMostShares];
};

template <typename Pieces, typename Body>
void in_stages(const Tasks& tasks, int stages, const Pieces& pieces, const Body& body)
{
    Stages<Pieces, Body> job(stages, tasks.workers(), pieces, body);
    tasks.for_each(tasks.workers(), [&](int, int worker) { job.serve(worker); });
}

}  // namespace epode
