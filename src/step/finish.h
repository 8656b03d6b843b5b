// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Finishes every body that took part in a step: marks its geoms as moved, calls its callback, looks at its speed, applies
// damping and clears its accumulators. For most bodies the worker that has them in its cache does this as soon as
// their islands are solved. Left to the end, in the order of the islands on the caller's thread, are bodies
// with a callback, those whose geoms share lists with others, and all bodies if continuous collision needs
// their motion when all have moved (step/common/continuous).
#pragma once

#include <atomic>

#include "base/arena.h"
#include "step/common/continuous.h"
#include "step/common/runaway.h"
#include "tasks/tasks.h"

namespace epode {

struct Space;

// The bodies that are not `done`, while their callbacks are called.
struct Unfinished {
    std::span<Body* const> bodies;
    std::span<bool> done;
    bool has(std::size_t i) const { return i < bodies.size() && !done[i]; }
};
// A callback has left the step, which has been made: no other is called.
void finish_silently(Unfinished& left, Runaways& runaways);

class Finish {
  public:
    // `contact_space`: the space of the world-managed contacts, or null.
    Finish(const Continuous& continuous, Space* contact_space, Runaways& runaways, const Tasks& tasks)
        : continuous_(continuous),
          contact_space_(contact_space),
          runaways_(runaways),
          alone_(tasks.workers() == 1)
    {}

    // `bodies`: of all islands; `early`: nobody needs their motion later. False: out of memory.
    [[nodiscard]] bool begin(std::span<Body* const> bodies, bool early, Arena& arena);
    bool is_early() const { return early_; }
    // Finishes a piece of the bodies whose islands are solved. On any worker.
    void at_once(std::span<Body* const> piece, const Tasks& tasks);
    // Finishes the bodies that are left, at the end of the step.
    void rest(Unfinished& left);
    // The step has been undone: geoms may stay marked.
    void take_back() { report_marked(); }

  private:
    bool mark_geoms(Body& body) const;
    bool moves_geoms(const Body& body) const;
    void report_marked() const;
    [[nodiscard]] bool list_marked() const;

    const Continuous& continuous_;
    Space* const contact_space_;
    Runaways& runaways_;
    const bool alone_;
    bool early_ = false;
    std::span<Body* const> bodies_;
    std::span<bool> done_;  // of bodies_
    std::atomic<bool> any_left_{false};
};

}  // namespace epode
