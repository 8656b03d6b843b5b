// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An island whose joints are forests of links, in joint coordinates. Velocities u of the degrees of freedom ("dofs") move the bodies:
//
//   v = T u;   of body b with centre x_b, about the reference O of its tree, the centre of the root's body:
//   w_b = sum a_i u_i,  v_b = sum l_i u_i + w_b x (x_b - O)      over the dofs i on the chain from the root to b
//
// with the motion subspace (a_i, l_i) of a dof: spin and velocity at O. Axes are those of the world, so that nothing is transformed on
// the way along a chain (Featherstone, "Rigid Body Dynamics Algorithms", 2008, with one frame for all links). A root that nothing
// holds has six dofs. Parents come before children, and the dofs of a link behind those of its parent.
#pragma once

#include <span>

#include "base/arena.h"
#include "rows/row_system.h"

namespace epode {

enum class LinkJoint : unsigned char { kNone, kFree, kBall, kHinge, kSlider, kFixed };

// How many rows of a block hold such a joint: its first ones.
constexpr int lock_rows(LinkJoint joint)
{
    return joint == LinkJoint::kBall                                   ? 3
           : joint == LinkJoint::kHinge || joint == LinkJoint::kSlider ? 5
           : joint == LinkJoint::kFixed                                ? 6
                                                                       : 0;
}

// A motion (spin, velocity at O) or what acts along it (torque about O, force).
struct Spatial {
    Vec3 ang, lin;
};
constexpr Real dot(const Spatial& a, const Spatial& b) { return dot(a.ang, b.ang) + dot(a.lin, b.lin); }
constexpr Spatial operator+(const Spatial& a, const Spatial& b) { return {a.ang + b.ang, a.lin + b.lin}; }
constexpr Spatial operator-(const Spatial& a, const Spatial& b) { return {a.ang - b.ang, a.lin - b.lin}; }
constexpr Spatial operator*(Real s, const Spatial& a) { return {s * a.ang, s * a.lin}; }

struct TreeLink {
    int body = 0;              // of the system
    int parent = -1;           // link; -1: the world, or nothing if the joint is kFree
    int root = 0;              // link
    int block = -1;            // whose rows hold it
    int first = 0, count = 0;  // dofs
    int last = -1;             // the last dof of the chain that ends here; -1: it has none
    LinkJoint joint = LinkJoint::kFree;
    bool is_body1 = true;  // of the block
    Vec3 from_root;        // x_b - O
    Vec3 anchor;           // of the joint, from O
};

class JointTree {
  public:
    static constexpr int kMaxLinks = 128, kMaxDofs = 192;

    // Of the bodies at these centres; kinds: of each block, what it leaves free, or kNone if it holds no link. Where joints make loops,
    // one of each loop is no branch. False: out of memory. If there is too much of them, fits() is false.
    bool build(const RowSystem& system, std::span<const Vec3> centres, std::span<const LinkJoint> kinds,
               Arena& arena);
    bool fits() const { return fits_; }

    std::span<const TreeLink> links() const { return links_; }
    const TreeLink& link(int i) const { return links_[std::size_t(i)]; }
    int link_of_body(int body) const { return body < 0 ? -1 : link_of_body_[std::size_t(body)]; }
    // The link that this block of the system holds as a joint of the tree; null: none.
    const TreeLink* branch(const RowSystem& system, int block) const;
    int dofs() const { return int(motions_.size()); }
    const Spatial& motion(int dof) const { return motions_[std::size_t(dof)]; }
    // The next dof towards the root, -1: none; and how many there are up to there.
    int up(int dof) const { return up_[std::size_t(dof)]; }
    int depth(int dof) const { return depth_[std::size_t(dof)]; }

    // Of a link that the step has moved, parents first: its place from O, its joint's anchor, and its motions, turned with the parent.
    void move(int link, Vec3 from_root, Vec3 anchor, std::span<const Spatial> motions);

    // T u: of each link the spin and the velocity of its centre.
    void velocities(std::span<const double> u, std::span<Spatial> of_links) const;
    // T^T of what acts on each link, torque about its centre and force. Leaves there what acts on the link with all that hangs on it,
    // about O.
    void gather(std::span<Spatial> of_links, std::span<double> out) const;
    // An impulse on a link, at its centre, about O.
    static Spatial about_root(const TreeLink& link, Vec3 force, Vec3 torque)
    {
        return {torque + cross(link.from_root, force), force};
    }

  private:
    bool take_memory(const RowSystem& system, Arena& arena);
    void collect_edges(const RowSystem& system, std::span<const LinkJoint> kinds);
    void grow(const RowSystem& system, std::span<const LinkJoint> kinds, int& done);
    bool add_link(int body, int parent, int block, LinkJoint joint, bool is_body1);
    void hang_on_world(const RowSystem& system, std::span<const LinkJoint> kinds);
    void place(const RowSystem& system, std::span<const Vec3> centres);
    void place_motions(const RowSystem& system, const TreeLink& link);

    std::span<TreeLink> links_;
    std::span<Spatial> motions_, scratch_;
    std::span<int> up_, depth_, link_of_body_;
    std::span<int> edge_of_body_, next_edge_;  // 2 k and 2 k + 1: of body 1 and body 2 of block k; -1: none
    int count_ = 0, dofs_ = 0;
    bool fits_ = false;
};

}  // namespace epode
