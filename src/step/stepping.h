// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Marks a world as stepping. The program's functions run during a step (memory, threading, callbacks), so calls that
// would change what the step works on are refused until it ends. A batch marks its worlds itself, for longer. If such a
// function leaves the step (base/call_guard.h), the mark is the last thing that is left of it.
#pragma once

#include "step/step.h"

namespace epode {

class Stepping {
  public:
    explicit Stepping(World& world) : guard_(leave, &world, nullptr, std::size_t(world.busy)), world_(world)
    {
        before_ = world.busy;
        mark_busy(world, Busy::kStep);
    }
    ~Stepping()
    {
        if (guard_.end()) mark_busy(world_, before_);
    }

  private:
    static void leave(void* world, const void*, std::size_t before);

    CallGuard guard_;
    World& world_;
    Busy before_;
};

}  // namespace epode
