// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step that runs out of memory goes back to, so that it has never happened: the next one gives the
// bits that this one would have given. Kept are poses, velocities and forces of the bodies that are stepped,
// who sleeps, how long idle bodies have been idle, and the impulses that joints start from; that is a copy
// of 300 bytes per body. To find out beforehand whether memory will do is not possible, since the fill of a
// factor is known only when it is planned, and islands are finished one by one. The contact cache takes care
// of itself.
#pragma once

#include "dynamics/island.h"

namespace epode {

class StepUndo {
  public:
    explicit StepUndo(World& world) : world_(world) {}

    // Before the test for idle bodies. False: out of memory.
    [[nodiscard]] bool save_idleness(Arena& arena);
    // After the search for islands; bodies that sleep although an awake one reaches them wake up here.
    [[nodiscard]] bool save_islands(std::span<const Island> islands, Arena& arena);
    // All that has been saved.
    void restore() const;

    // The bodies of all islands, one after the other, and where each was when the step began.
    std::span<Body* const> bodies() const { return bodies_; }
    Pose pose_before(std::size_t i) const { return load_pose(saved_[i].pos, saved_[i].R); }
    Quat orientation_before(std::size_t i) const { return load_quat(saved_[i].q); }

  private:
    struct Idleness {  // and what a body loses that falls asleep
        Real lvel[4], avel[4];
        Vec3 spin_excess;
        Real time_left;
        int steps_left, next_sample;
        bool samples_ready, disabled;
    };
    struct Saved {
        Real pos[4], q[4], R[12], lvel[4], avel[4], facc[4], tacc[4];
        Vec3 spin_excess;
        bool disabled;
    };

    [[nodiscard]] bool save_impulses(Arena& arena);
    void restore_bodies() const;
    void restore_impulses() const;

    World& world_;
    std::span<Idleness> idleness_;   // of the bodies that watch themselves, in the world's order
    std::span<Body* const> bodies_;  // of all islands, one after the other
    std::span<Joint* const> joints_;
    std::span<Saved> saved_;       // of bodies_
    std::span<int> impulse_rows_;  // of joints_
    std::span<Real> impulses_;
};

}  // namespace epode
