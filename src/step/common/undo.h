// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Restores the world when a step runs out of memory, so that the next step gives the bits that this one would
// have given. Saved are poses, velocities and forces of the bodies that are stepped, which bodies sleep, how
// long idle bodies have been idle, and the impulses that joints start from: 300 bytes per body. Whether
// memory will suffice cannot be known before: the fill-in of a factor is known only after its symbolic
// factorisation, and islands are finished one by one. The contact cache has its own undo.
#pragma once

#include "dynamics/island.h"

namespace epode {

class StepUndo {
  public:
    explicit StepUndo(World& world) : world_(world) {}

    // Before the search for islands, which finds the idle ones. False: out of memory.
    [[nodiscard]] bool save_idleness(Arena& arena);
    // Wakes bodies that slept, before that search. False: out of memory.
    [[nodiscard]] bool wake(std::span<Body* const> sleepers, Arena& arena);
    // After the search for islands: saves the impulses of their joints and reserves memory for their bodies.
    // Sleeping bodies that an awake one reaches wake up here.
    [[nodiscard]] bool save_islands(std::span<const Island> islands, Arena& arena);
    // Before fluids act on bodies(): their accumulators and what fluids did to them. mark_fluids(): now they are changed. False: out of
    // memory.
    [[nodiscard]] bool save_fluids(Arena& arena);
    void mark_fluids() { fluids_act_ = true; }
    // Saves body i of bodies() when its island begins, on the worker that is about to read it anyway.
    void save(std::size_t i);
    // All that has been saved.
    void restore() const;
    // Poses, velocities and forces of a piece of bodies(), as they were when the step began.
    void restore_bodies(std::span<Body* const> piece) const;
    // Poses of a piece of bodies() as they were when the step began, and what of the momentum velocities did not show.
    void restore_poses(std::span<Body* const> piece) const;

    // The bodies of all islands, one after the other, and where each was when the step began.
    std::span<Body* const> bodies() const { return bodies_; }
    std::size_t first_of(std::span<Body* const> piece) const
    {
        return std::size_t(piece.data() - bodies_.data());
    }
    Pose pose_before(std::size_t i) const { return {saved_[i].position, saved_[i].rotation}; }
    Vec3 velocity_before(std::size_t i) const { return saved_[i].velocity; }
    Quat orientation_before(std::size_t i) const { return saved_[i].orientation; }

  private:
    struct Idleness {  // and what a body loses that falls asleep
        Body* body;
        Real lvel[4], avel[4];
        Vec3 spin_excess;
        Stillness short_window, long_window;
        Real settling_time;
        Real time_left;
        int steps_left, next_sample;
        bool samples_ready, slept;
    };
    static void take_idleness(Body& body, Idleness& to);
    static void restore_idleness(std::span<const Idleness> from);
    struct Saved {  // of four lines of the cache
        Vec3 position;
        Quat orientation;
        Mat3 rotation;
        Vec3 velocity, angular_velocity, force, torque, spin_excess;
    };
    struct BeforeFluids {
        Vec3 force, torque;
        BodyInFluid fluid;
    };
    struct Mark {
        bool slept, saved, had_manifolds;
    };
    struct Remembering {
        Joint* joint;
        std::uint8_t rows, mean_rows;
    };

    [[nodiscard]] bool save_sleepers(std::span<Body* const> sleepers, Arena& arena);
    [[nodiscard]] bool wake_reached(int count, Arena& arena);
    [[nodiscard]] bool save_impulses(std::span<const Island> islands, Arena& arena);
    void restore_body(std::size_t i) const;
    static void restore_pose(Body& body, const Saved& saved);
    void restore_impulses() const;
    void restore_fluids() const;

    World& world_;
    std::span<Idleness> idleness_;  // of the awake bodies that watch themselves
    // Of bodies that the step has woken: unsupported, and reached by islands.
    std::span<Idleness> woken_[2];
    int wakings_ = 0;
    std::span<Body* const> bodies_;  // of all islands, one after the other
    std::span<Joint* const> joints_;
    std::span<Saved> saved_;                 // of bodies_
    std::span<Mark> marks_;                  // likewise
    std::span<BeforeFluids> before_fluids_;  // likewise
    bool fluids_act_ = false;
    std::span<Remembering> remembering_;
    std::span<Real> impulses_;
};

}  // namespace epode
