// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The number of the worker that a thread is while it runs pieces of a job; -1 otherwise. A job that begins
// inside a piece runs on the thread of that piece, under its number.
#pragma once

namespace epode {

extern constinit thread_local int t_worker;

class AsWorker {
  public:
    explicit AsWorker(int worker) : before_(t_worker) { t_worker = worker; }
    AsWorker(const AsWorker&) = delete;
    AsWorker& operator=(const AsWorker&) = delete;
    ~AsWorker() { t_worker = before_; }

  private:
    int before_;
};

}  // namespace epode
