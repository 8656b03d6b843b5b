// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is due to every body that took part in a step: its geoms are marked as moved, then come its callback
// and damping, and its accumulators are emptied. Most bodies get this as soon as their islands are done, by
// the worker that has them in its cache. Left to the end, one after the other in the order of the islands on
// the caller's thread, are those with a callback, those whose geoms share lists with others, and all bodies
// if something looks at their ways when all have moved (step/continuous).
#pragma once

#include <atomic>

#include "base/arena.h"
#include "step/continuous.h"
#include "tasks/tasks.h"

namespace epode {

struct Space;

class Finish {
  public:
    // `managed`: the space whose contacts the world manages, or null.
    Finish(const Continuous& continuous, Space* contact_space, const Tasks& tasks)
        : continuous_(continuous), contact_space_(contact_space), alone_(tasks.workers() == 1)
    {}

    // `bodies`: of all islands; `early`: nothing will ask for their ways. False: out of memory.
    [[nodiscard]] bool begin(std::span<Body* const> bodies, bool early, Arena& arena);
    bool is_early() const { return early_; }
    // The islands of this piece of the bodies are done. On any worker.
    void at_once(std::span<Body* const> piece, const Tasks& tasks);
    // The step is made.
    void rest();
    // There has been no step: geoms may stay marked.
    void take_back() { report_marked(); }

  private:
    bool mark_geoms(Body& body) const;
    bool moves_geoms(const Body& body) const;
    void one(Body& body) const;
    void report_marked() const;
    [[nodiscard]] bool list_marked() const;

    const Continuous& continuous_;
    Space* const contact_space_;
    const bool alone_;
    bool early_ = false;
    std::span<Body* const> bodies_;
    std::span<bool> done_;  // of bodies_, if early
    std::atomic<bool> any_left_{false};
};

}  // namespace epode
