// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a step in joint coordinates holds besides the branches of the tree. Joints of an island that are no branches of its tree: those that close loops, and those of types that the tree
// does not have. Their rows act on the tree as those of contacts do. What holds such a joint together is closed where the step ends, by the
// impulses of the step, as in bodies (step/island/positions/shake.h, which has the theory):
//
//   e(q + h u) = e(q) - h (c - C p)        by  J du + C dp = e'/h,   e' being what e has more than that
//   J1 u1 = c1                             for the velocities that the step ends with, by  (J1 H1^-1 J1^T + C) dp = c1 - J1 u1
//
// The second also of motors that reach the rate that is asked for, of all joints: at the end they have it, too.
#pragma once

#include "solve/tree/tree_solve.h"
#include "step/island/problem/assemble.h"
#include "step/island/tree/tree_poses.h"

namespace epode {

class ClosingRows {
  public:
    // Of the joints that are no branches. False: out of memory.
    bool begin(const World& world, IslandWork& work, const JointTree& tree, Arena& arena);
    std::span<const bool> flags() const { return flags_; }  // by row of the system
    bool none() const { return closing_ == 0; }
    int size() const { return closing_; }
    // Of e, relative to levers: a difference of places has no more digits than they have.
    Real rounding() const { return 4 * kEpsilon * farthest_; }

    // After the solution: what e is to be where the step ends.
    void expect();
    // The largest e', relative to levers, where bodies have gone; it is set in `solve`. Bodies have the poses then.
    Real measure(const TreePoses& poses, TreeSolve& solve);
    void restore_poses() const;
    // What is left of e of each row where the step ends, to `errors` by row of the system. Returns the largest, relative to levers.
    Real find_gaps(std::span<double> errors) const;

    // Where bodies and tree are at the end, H1 in `factor`: u1 becomes what the rows want. False: they want nothing, out of memory, or they
    // contradict each other; nothing has changed then.
    bool hold(const TreeSolve& solve, const TreeFactor& factor, std::span<double> u, Arena& arena);
    // Less the impulses of hold(), which act at the end.
    void subtract_impulses(const JointTree& tree, std::span<Spatial> of_links) const;

  private:
    struct Closing {
        int block, place, source;  // place: in the block
        bool closes;               // else a motor
        Real per_arm, expected;
        Jacobian end;
        Real wanted, p;  // of hold()
    };
    struct Start {
        int body, link;
        Vec3 x;
        Quat q;
        Mat3 R;
    };
    int mark(const JointTree& tree);
    void collect();
    Real distance_of(const RowBlock& block) const;
    bool is_motor(int source) const;
    bool acts(const Closing& row) const;
    void save_poses(const JointTree& tree);
    void push(std::span<const double> Y, std::span<const double> dp, const TreeFactor& factor,
              std::span<double> u, Arena& arena);
    // f(closing, the row as its joint has it at the present poses).
    template <typename F>
    void for_each(F&& f);

    const World* world_ = nullptr;
    IslandWork* work_ = nullptr;
    std::span<bool> flags_;
    std::span<Closing> rows_;
    std::span<Start> starts_;
    int closing_ = 0;
    Real farthest_ = 0;  // from the origin, relative to levers
};

}  // namespace epode
