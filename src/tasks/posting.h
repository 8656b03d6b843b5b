// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs pieces of work as calls of a threading implementation, ours or a client's, known only by its table of
// functions. A job posts up to width() calls, each of which takes pieces until none is left, and one more
// call that depends on all of them and is waited for (a single call is waited for itself). As in ODE, the
// thread that posts runs none of them: the client chooses on which threads a step runs.
//
// An implementation that loses calls, runs them late or waits too briefly cannot change the result: when the
// wait is over, the waiting thread does the pieces that are left, and a call that arrives late finds a job
// without pieces.
#pragma once

#include "ode/threading.h"

namespace epode {

class Posting {
  public:
    using Piece = void (*)(void* body, int index, int worker);
    static constexpr int kMaxCalls = 64;

    Posting() = default;
    Posting(const Posting&) = delete;
    Posting& operator=(const Posting&) = delete;
    ~Posting() { close(); }

    // At most `limit` calls at a time; 0: as many as the implementation has threads. The table is copied.
    // False: the implementation refused to prepare, nothing was posted.
    bool open(const dThreadingFunctionsInfo& functions, dThreadingImplementationID impl, unsigned limit);
    void close();

    int width() const { return width_; }
    // Queries again how many threads there are.
    void measure(unsigned limit);

    // piece(body, index, worker) once for each index; worker 1 ... width() in a call, 0 in this thread. Not
    // to be called by two threads at the same time.
    void run(int calls, int count, Piece piece, void* body) const;

  private:
    void post_and_wait(int calls, void* job) const;

    dThreadingFunctionsInfo functions_{};
    dThreadingImplementationID impl_ = nullptr;
    dCallWaitID wait_ = nullptr;
    int width_ = 0;
};

}  // namespace epode
