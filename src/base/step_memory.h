// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The working memory of steps: one arena per worker, all with the same supply. Worlds that are never stepped
// at the same time may share it (dWorldUseSharedWorkingMemory); it counts its holders and is freed with the
// last. A step owns it from beginning to end, callbacks included. A world that is stepped inside the step of
// another world with the same memory is refused.
#pragma once

#include <atomic>

#include "base/arena.h"
#include "base/array.h"

namespace epode {

class StepMemory {
  public:
    // Null when memory is exhausted. The caller is the first holder.
    static StepMemory* create();
    StepMemory* hold();
    static void let_go(StepMemory* memory);  // null is allowed
    bool shared() const { return holders_.load(std::memory_order_relaxed) > 1; }

    // False: in use by another step.
    bool begin();
    void end() { in_use_.store(false, std::memory_order_release); }
    bool in_use() const { return in_use_.load(std::memory_order_relaxed) && still_in_use(); }

    // Between begin and end. False: no memory.
    bool provide(int workers);
    Arena& arena(int worker) { return worker == 0 ? own_ : *others_[worker - 1]; }

    // Not between begin and end.
    void set_supply(const ArenaSupply& supply);
    const ArenaSupply& supply() const { return supply_; }
    void free_blocks();

  private:
    StepMemory() = default;
    ~StepMemory();
    [[gnu::cold]] bool still_in_use() const;

    std::atomic<int> holders_{1};
    std::atomic<bool> in_use_{false};
    ArenaSupply supply_;
    Arena own_;
    Array<Arena*> others_;  // of the workers besides the caller
};

}  // namespace epode
