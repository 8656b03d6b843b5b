// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// While it lives, another thread has the library's pool.
#pragma once

#include <atomic>
#include <thread>

#include "tasks/tasks.h"

namespace epode {

class TakenPool {
  public:
    TakenPool()
    {
        while (!taken_) std::this_thread::yield();
    }
    ~TakenPool() { give_back(); }
    TakenPool(const TakenPool&) = delete;
    TakenPool& operator=(const TakenPool&) = delete;

    // Before the end; whoever asks first waits until it is free.
    void give_back()
    {
        if (!over_.exchange(true)) other_.join();
    }

  private:
    std::atomic<bool> taken_{false}, over_{false};
    std::thread other_{[this] {
        Tasks(2).for_each(2, [this](int, int) {
            taken_ = true;
            while (!over_) std::this_thread::yield();
        });
    }};
};

}  // namespace epode
