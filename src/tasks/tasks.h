// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Independent pieces of work on several cores. `for_each(count, body)` calls body(index, worker) once for
// every index, on any worker 0 ... workers() - 1, and returns when all are done. What a piece computes must
// depend on its index alone, never on its worker or on what runs at the same time; then the result has the
// same bits on any number of workers. `worker` is for scratch memory only. Pieces begin in the order of their
// indices: a piece may wait for one with a lower index. A call from inside a piece runs its own pieces in
// place, one after another.
//
// The workers are either the caller and threads of the library's own pool (tasks/thread_pool.h), or calls of
// a threading implementation that the program has given (tasks/posting.h), which the caller only waits for.
#pragma once

#include "tasks/posting.h"

namespace epode {

class Tasks {
  public:
    // `workers` counts the caller; at least 1.
    explicit Tasks(int workers = 1) : workers_(workers < 1 ? 1 : workers) {}

    // Uses posted calls. A job of one piece is posted too, instead of run here, if `even_one`.
    explicit Tasks(const Posting& posting, bool even_one)
        : workers_(posting.width() + 1), posting_(&posting), least_(even_one ? 1 : 2)
    {}

    int workers() const { return workers_; }

    // A hint that may change at any time: no worker would help with a job now. Work that is slower in pieces
    // should then not be divided; memory should be sized by workers(), which does not change.
    bool alone() const;

    template <typename Body>
    void for_each(int count, Body&& body) const
    {
        if (workers_ == 1 || count < least_) {
            for (int i = 0; i < count; ++i) body(i, 0);
            return;
        }
        run(
            count, [](void* b, int i, int worker) { (*static_cast<Body*>(b))(i, worker); }, &body);
    }

    // body(first, last) for ranges of 0 ... count - 1, `size` long but for the last.
    template <typename Body>
    void in_ranges(int count, int size, Body&& body) const
    {
        if (workers_ == 1) return count > 0 ? body(0, count) : void();
        for_each((count + size - 1) / size,
                 [&](int i, int) { body(i * size, i * size + size < count ? i * size + size : count); });
    }

    // body(i) for 0 ... count - 1, in such ranges.
    template <typename Body>
    void each_of(int count, int size, Body&& body) const
    {
        in_ranges(count, size, [&](int first, int last) {
            for (int i = first; i < last; ++i) body(std::size_t(i));
        });
    }

  private:
    using Piece = void (*)(void* body, int index, int worker);
    void run(int count, Piece piece, void* body) const;

    int workers_;
    const Posting* posting_ = nullptr;
    int least_ = 2;  // the fewest pieces that are worth sharing
};

// Workers that the machine can run at once.
int processor_count();

}  // namespace epode
