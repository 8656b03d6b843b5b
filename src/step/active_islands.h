// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The islands of a step: contacts of the world are updated, bodies that touch or hold each other connected; what a moving
// body reaches becomes active, and what is idle falls asleep.
#pragma once

#include "dynamics/island.h"
#include "step/step.h"
#include "tasks/tasks.h"

namespace epode {

class ActiveIslands {
  public:
    ActiveIslands(World& world, StepState& state, Real h, const Tasks& tasks)
        : world_(world), state_(state), h_(h), tasks_(tasks)
    {}

    // False: out of memory.
    [[nodiscard]] bool find(StepUndo& undo, Arena& arena);
    std::span<const Island> all() const { return islands_; }

    // Are world-managed contacts updated in this step?
    bool updates_contacts() const { return updates_contacts_; }

    // After the step.
    void accept_contacts() const;
    // Before sleeping bodies' pairs are laid to rest.
    void list_events() const;
    // Takes sleeping bodies out of the active ones, so that later steps skip them.
    void deactivate_sleeping() const;

  private:
    bool manages_contacts() const { return state_.world_contacts.live_space() != nullptr; }
    bool is_settled() const;
    bool leaves_at_rest(int active) const;
    bool find_unsupported();
    bool find_contacts();
    bool find_islands(Arena& arena);
    bool activate_reached();

    World& world_;
    StepState& state_;
    const Real h_;
    const Tasks& tasks_;
    bool updates_contacts_ = false;
    std::span<Island> islands_;
    std::span<Body*> asleep_;  // active bodies that have fallen asleep
};

}  // namespace epode
