// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs of geoms of which a step has looked at a part only, in continuous collision or for a sensor, because one
// covers more of the other's surface than a query looks at (query/effort.h). The program learns of the first such
// step of a world in one message; steps go on.
#pragma once

#include "collide/geom.h"
#include "dynamics/world.h"

namespace epode {

class CutShort {
  public:
    // During a step, on the caller's thread.
    [[gnu::cold]] void add(const Geom& a, const Geom& b, const char* by);
    // The step has been undone.
    void take_back() { by_ = nullptr; }
    // Between steps, when nothing of them is left on the stack: sends the message.
    void report(const World& world)
    {
        if (by_ && !reported_) [[unlikely]]
            send(world);
    }

  private:
    [[gnu::cold]] void send(const World& world);

    const char* by_ = nullptr;  // null: nothing to be said
    int classes_[2] = {};
    bool reported_ = false;
};

}  // namespace epode
