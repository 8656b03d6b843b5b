// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step that runs out of memory goes back to: poses, velocities and forces of all bodies that it steps,
// copied before the first island is solved. That costs a copy of 300 bytes per body and step; to find out
// beforehand whether memory will do is not possible, since the fill of a factor is known only when it is
// planned, and islands are finished one by one. What an impulse or a contact remembers as a first guess is
// not taken back.
#pragma once

#include "dynamics/island.h"

namespace epode {

class StepUndo {
  public:
    // False: out of memory.
    [[nodiscard]] bool save(std::span<const Island> islands, Arena& arena);
    void restore(std::span<const Island> islands) const;

  private:
    struct Saved {
        Real pos[4], q[4], R[12], lvel[4], avel[4], facc[4], tacc[4];
        Vec3 spin_excess;
    };
    std::span<Saved> saved_;  // island by island
};

}  // namespace epode
