// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Poses of a tree's bodies from displacements dq of its dofs, parents first: nothing opens, whatever dq is. In the frame of the parent P
// of a link C (the world's, if it has none),
//
//   q_C = q_P exp(turn + e) r            r = q_P0^-1 q_C0 at the beginning
//   x_C = x_P + R_P a_P - R_C a_C        hinge, ball: a, where the anchor is in each body
//   x_C = x_P + R_P (d + slide + e)      slider, fixed: d = R_P0^T (x_C0 - x_P0)
//
// e closes what is open at the beginning, to first order, and so to nothing in a few steps. A free root turns by exp(dq) in the world.
#pragma once

#include "solve/tree/joint_tree.h"
#include "step/island/problem/assemble.h"

namespace epode {

class TreePoses {
  public:
    // At the beginning of a step. False: out of memory.
    bool begin(const IslandWork& work, const JointTree& tree, Arena& arena);

    // Poses after dq; bodies do not move yet.
    void go(std::span<const double> dq);
    // v h and w h that lead from the beginning to those poses.
    Spatial displacement(int link) const;
    Vec3 position(int link) const { return now_[std::size_t(link)].x; }
    Quat orientation(int link) const { return now_[std::size_t(link)].q; }
    const Mat3& rotation(int link) const { return now_[std::size_t(link)].R; }

    void shift(int link, Vec3 way) { now_[std::size_t(link)].x += way; }
    const Mat3& rotation_before(int link) const { return before_[std::size_t(link)].R; }

    // The tree with its motions at those poses.
    void move(JointTree& tree) const;

  private:
    struct Place {
        Vec3 x;
        Quat q;
        Mat3 R;
    };
    struct Local {  // of a link, in the frame of its parent, but own_anchor in its own
        Vec3 axis, anchor, own_anchor, offset, turn;  // offset, turn: with what closes the joint
        Quat relative;
    };
    Place parent_of(const TreeLink& link, std::span<const Place> places) const;
    Local local(const IslandWork& work, const JointTree& tree, const TreeLink& link, std::size_t i) const;
    void go(std::size_t i, const double* dq);

    const JointTree* tree_ = nullptr;
    std::span<Place> before_, now_;
    std::span<Local> locals_;
};

}  // namespace epode
