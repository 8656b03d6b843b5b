// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a tree moves once the velocities u of its joints are known (solve/tree). Poses follow from q + h u, so joints stay closed. What
// bodies do on the way between the two poses, v' = x(q + h u) - x(q) over h (turns by their logarithms), is T u + O(h): inertia takes it
// into account if the impulses of the step lead there (SHAKE, as in step/island/positions/shake.h, where it is the joints that are to close),
//
//   T^T M (v' - v) + sum j j du / C = sum_acting j dp,   J du + C dp = 0 of the rows that act
//
// by Newton's method with the H of the beginning. Without it a joint would lose about (w h)^2/2 of its lever's motion in each step. Where
// the step ends, velocities are those that the joints allow there (RATTLE): the nearest in the metric of the masses.
// What is beyond a stop or inside a contact is removed by the least displacement of the joints, as project_poses does with bodies.
#pragma once

#include "solve/tree/tree_solve.h"
#include "step/island/positions/projection.h"
#include "step/island/tree/tree_poses.h"

namespace epode {

class TreeMotion {
  public:
    // After the solution. `tree` moves along. False: out of memory.
    bool begin(const World& world, IslandWork& work, JointTree& tree, TreeSolve& solve, Arena& arena);

    // The velocities and impulses with which the bodies get to their poses; bodies are there then. `is_raised`: inertias are
    // (positions/tension.h), and what that has taken is not given back. False: out of memory.
    bool advance(bool is_raised);
    // Removes what is beyond stops and inside contacts. Behind advance().
    ProjectionReport project();
    // Velocities that joints allow at the end, in the bodies of the system and of the world, and p of the rows of joints, from which
    // the next step knows the tension in light links. Behind project(). False: out of memory.
    bool settle_velocities();

  private:
    std::size_t size() const { return size_; }
    SolverBody& solver_body(std::size_t link) const
    {
        return work_->system.bodies[std::size_t(tree_->link(int(link)).body)];
    }
    Body& body(std::size_t link) const
    {
        return *work_->island.bodies[std::size_t(tree_->link(int(link)).body)];
    }
    void measure_path();
    void gather_momentum(std::span<const Spatial> velocities, std::span<double> out);
    bool is_too_long() const;
    bool iterate();
    void fly();
    void keep_momentum();
    void store_poses() const;
    void turn_excess() const;
    Spatial seen(std::size_t link) const;
    void find_rates(std::span<double> rates) const;
    void find_joint_impulses();
    void add_last_impulses(std::span<Spatial> changes);
    Real gap(const RowBlock& block, const Row& row, std::size_t block_index) const;
    Real find_gaps(std::span<double> errors) const;

    const World* world_ = nullptr;
    IslandWork* work_ = nullptr;
    JointTree* tree_ = nullptr;
    TreeSolve* solve_ = nullptr;
    Arena* arena_ = nullptr;
    TreePoses poses_;
    std::size_t size_ = 0;
    std::span<Spatial> before_, path_, scratch_;  // v*, v'
    std::span<Spatial> impulses_;                 // of joints, about their anchors
    std::span<double> momentum_, r_, dq_;
};

}  // namespace epode
