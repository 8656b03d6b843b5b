// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Poses of a tree's bodies from displacements dq of its dofs, parents first: nothing opens, whatever dq is. Against the beginning, a body
// has turned by d (a quaternion in the world's axes) and its centre has gone y. Of a link C with the parent P (the world, if it has
// none: d = 1, y = 0), in the world's axes at the beginning,
//
//   d_C = d_P exp(own turn)                         own turn: dq along the axis of a hinge, dq of a ball, 0 of others
//   y_C = y_P + (d_P - 1) a_P - (d_C - 1) a_C       hinge, ball, fixed: a, from the centres to where the joint is
//   y_C = y_P + (d_P - 1) a_P + d_P dq axis         slider: a_P to the centre of C
//
// with (d - 1) a = d a d^-1 - a, so that small displacements have as many digits as large ones. A free root turns by exp(dq).
// What is open at the beginning, e, is closed apart from that, to first order, and so to nothing in a few steps: as a displacement of the
// poses, which is no motion.
#pragma once

#include "solve/tree/joint_tree.h"
#include "step/island/problem/assemble.h"

namespace epode {

class TreePoses {
  public:
    // At the beginning of a step. False: out of memory.
    bool begin(const IslandWork& work, const JointTree& tree, Arena& arena);

    // Displacements after dq; bodies do not move yet.
    void go(std::span<const double> dq) { go_all(dq, false); }
    // With what closes the joints.
    void go_and_close(std::span<const double> dq) { go_all(dq, true); }
    // v h and w h that lead from the beginning to there.
    Spatial displacement(int link) const;
    void shift(int link, Vec3 way) { places_[std::size_t(link)].y += way; }

    // Poses at the displacements.
    Vec3 position(int link) const { return before(link).x + places_[std::size_t(link)].y; }
    Quat orientation(int link) const;
    void store(int link, Body& to) const;
    // The tree with its motions at those poses.
    void move(JointTree& tree) const;

  private:
    struct Before {
        Vec3 x;
        Quat q;
    };
    struct Place {
        Vec3 y;
        Quat d;
    };
    struct Local {  // of a link; turn, way: what closes its joint
        Vec3 axis, parents_arm, own_arm, turn, way;
    };
    const Before& before(int link) const { return before_[std::size_t(link)]; }
    Vec3 parent_before(const TreeLink& link) const
    {
        return link.parent < 0 ? Vec3{} : before(link.parent).x;
    }
    Place parent_of(const TreeLink& link) const;
    Local local(const IslandWork& work, const JointTree& tree, const TreeLink& link, std::size_t i) const;
    void set_arms(const TreeLink& link, const RowBlock& block, Vec3 gap, std::size_t i, Local& out) const;
    void go_all(std::span<const double> dq, bool closes);
    void go(std::size_t i, const double* own, bool closes);

    const JointTree* tree_ = nullptr;
    std::span<Before> before_;
    std::span<Place> places_;
    std::span<Local> locals_;
};

}  // namespace epode
