// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Threads that share numbered pieces of work. Who does which piece is left to chance: pieces must not depend on it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace epode::batch {

class Crew {
  public:
    // The caller works too; threads of at least 1. is_pinned: where the system can, each helper stays on a processor of its own among
    // those that the process may use, the first of which is left to the caller.
    explicit Crew(int threads, bool is_pinned = false);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    int size() const { return int(helpers_.size()) + 1; }
    // do_piece(piece, worker) for all pieces, workers 0 ... size() - 1; it throws nothing. One caller at a time.
    void work(int pieces, const std::function<void(int, int)>& do_piece);

  private:
    void help(int worker);
    void take_pieces(int worker);

    std::vector<std::thread> helpers_;
    std::mutex mutex_;
    std::condition_variable begun_, done_;
    const std::function<void(int, int)>* do_piece_ = nullptr;
    std::atomic<int> next_{0};
    int pieces_ = 0, round_ = 0, busy_ = 0;
    bool ends_ = false;
};

}  // namespace epode::batch
