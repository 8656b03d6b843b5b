// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How a tree moves: a variational integrator in the coordinates of its joints. A step leads from poses x to x(q + h u), and between the two
// each body flies freely by its part of the way: with the way over h, v' and w' (turns by their logarithms), it has the momentum
//
//   P = m v',   L = I w' + (h/2) s w' x I w',   s = tan(a)/a, a = h |w'|/2        (dynamics/exact_spin.h: L is the same at both ends)
//
// Where bodies fly on from their last poses, joints and rows exert impulses along what they allow there:
//
//   T^T (P, L) = T^T (P, L)_before + h forces + sum j p,   J u + C p = c of the rows that act
//
// an equation for u. Where the step ends, velocities are those that joints allow there with the same momentum, H1 u1 = T1^T (P, L). The map
// from x, v to the next ones is symplectic (Marsden & West, "Discrete mechanics and variational integrators", Acta Numerica 2001; Lee,
// Liu, Park & Srinivasa, "A linear-time variational integrator for multibody systems", 2016): energy does not drift, momenta are kept, and
// joints are closed. First the rows are solved, with the P, L that the velocities of the beginning would have in place of M v:
//
//   (P, L)(u) = M T u + (P, L)(u0) - M T u0 + O(h du)
//
// then u is corrected by quasi-Newton steps with the H of the beginning, in which the rows that act move as they do, extrapolated from
// the last three of them (Anderson, "Iterative procedures for nonlinear integral equations", 1965).
// What is beyond a stop or inside a contact is removed by the least displacement of the joints, as project_poses does with bodies.
#pragma once

#include "solve/tree/tree_solve.h"
#include "step/island/positions/projection.h"
#include "step/island/tree/closing_rows.h"
#include "step/island/tree/tree_poses.h"

namespace epode {

class TreeMotion {
  public:
    // Before TreeSolve::prepare: v* of the system, in which bodies keep their momenta (ProblemForm::keeps_momentum), become those with
    // which M v* is the momentum that the solution has to reach. False: out of memory.
    bool begin(const World& world, IslandWork& work, JointTree& tree, TreeSolve& solve, ClosingRows& closing,
               Arena& arena);
    // Is the step too long for the tree's turns?
    bool is_too_long() const { return too_long_; }

    // After the solution: u, the impulses of its rows, and momenta; bodies do not move yet. False: it does not converge, or out of memory.
    bool find_way();
    // Bodies are at the end of the way then, joints closed.
    void advance();
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
    Spatial momentum_of(std::size_t link, const Spatial& v) const;
    void measure_momenta(std::span<const double> u);
    bool iterate();
    bool is_thrown_by_closing();
    void find_rates(std::span<double> rates) const;
    void keep_momentum();
    void store_poses() const;
    void find_joint_impulses();
    void add_last_impulses(std::span<Spatial> changes);
    Real gap(const RowBlock& block, const Row& row, std::size_t block_index) const;
    Real find_gaps(std::span<double> errors) const;

    const World* world_ = nullptr;
    IslandWork* work_ = nullptr;
    JointTree* tree_ = nullptr;
    TreeSolve* solve_ = nullptr;
    ClosingRows* closing_ = nullptr;
    Arena* arena_ = nullptr;
    TreePoses poses_;
    std::size_t size_ = 0;
    bool too_long_ = false;
    std::span<Spatial> before_, bias_;   // of links: momenta after forces; (P, L) - M T u at the beginning
    std::span<Spatial> path_, momenta_;  // v', w' of the way; P, L
    std::span<Spatial> scratch_, impulses_;  // of joints, about their anchors
    std::span<double> momentum_, r_, dq_;
};

}  // namespace epode
