// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the bindings of batches and of environments on them share.
#pragma once

#include "robots.h"

#ifdef EPODE_HAVE_ROBOTS

#include <unistd.h>

#include <atomic>

#include "batch/batch.h"

namespace bound {

using epode::batch::AnyBatch;

struct BoundBatch {
    std::unique_ptr<AnyBatch> batch;
    std::atomic<bool> is_busy{false};
    pid_t process = getpid();

    AnyBatch& its() const { return *batch; }
};

// Throws where another thread uses the batch, or a child process that has none of its threads.
class Use {
  public:
    explicit Use(BoundBatch& batch) : batch_(batch)
    {
        if (batch.process != getpid())
            throw std::runtime_error("a batch does not live on in a forked process: make one there");
        if (batch.is_busy.exchange(true)) throw std::runtime_error("another thread uses this batch");
    }
    ~Use() { batch_.is_busy = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

  private:
    BoundBatch& batch_;
};

}  // namespace bound

#endif
