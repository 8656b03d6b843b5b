// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Trees grow from links that the world holds, then from the heaviest body of what is left. A kinematic body is the world.
#include "solve/tree/joint_tree.h"

#include <algorithm>

namespace epode {
namespace {

constexpr Vec3 kUnit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

int dof_count(LinkJoint joint)
{
    switch (joint) {
        case LinkJoint::kFree:
            return 6;
        case LinkJoint::kBall:
            return 3;
        case LinkJoint::kHinge:
        case LinkJoint::kSlider:
            return 1;
        default:
            return 0;
    }
}

bool moves(const RowSystem& system, int body)
{
    return body >= 0 && system.bodies[std::size_t(body)].inv_mass > 0;
}

}  // namespace

bool JointTree::build(const RowSystem& system, std::span<const Vec3> centres,
                      std::span<const LinkJoint> kinds, Arena& arena)
{
    fits_ = false;
    if (int(system.bodies.size()) > kMaxLinks) return true;
    if (!take_memory(system, arena)) return false;
    count_ = dofs_ = 0;
    collect_edges(system, kinds);
    hang_on_world(system, kinds);
    int done = 0;
    grow(system, kinds, done);
    for (;;) {
        int root = -1;
        for (int b = 0; b < int(system.bodies.size()); ++b)
            if (moves(system, b) && link_of_body_[std::size_t(b)] < 0 &&
                (root < 0 || system.bodies[std::size_t(b)].mass > system.bodies[std::size_t(root)].mass))
                root = b;
        if (root < 0) break;
        add_link(root, -1, -1, LinkJoint::kFree, true);
        grow(system, kinds, done);
    }
    if (dofs_ > kMaxDofs) return true;
    links_ = links_.first(std::size_t(count_)), motions_ = motions_.first(std::size_t(dofs_));
    place(system, centres);
    fits_ = true;
    return true;
}

bool JointTree::take_memory(const RowSystem& system, Arena& arena)
{
    const int bodies = int(system.bodies.size()), blocks = int(system.blocks.size());
    links_ = arena.take<TreeLink>(bodies);
    link_of_body_ = arena.take<int>(bodies), edge_of_body_ = arena.take<int>(bodies);
    next_edge_ = arena.take<int>(2 * blocks);
    motions_ = arena.take<Spatial>(6 * bodies), scratch_ = arena.take<Spatial>(bodies);
    up_ = arena.take<int>(6 * bodies), depth_ = arena.take<int>(6 * bodies);
    return !arena.failed();
}

void JointTree::collect_edges(const RowSystem& system, std::span<const LinkJoint> kinds)
{
    std::fill(link_of_body_.begin(), link_of_body_.end(), -1);
    std::fill(edge_of_body_.begin(), edge_of_body_.end(), -1);
    for (int e = 2 * int(kinds.size()) - 1; e >= 0; --e) {
        const RowBlock& block = system.blocks[std::size_t(e / 2)];
        const int body = e % 2 == 0 ? block.body1 : block.body2;
        if (kinds[std::size_t(e / 2)] == LinkJoint::kNone || body < 0) continue;
        next_edge_[std::size_t(e)] = edge_of_body_[std::size_t(body)], edge_of_body_[std::size_t(body)] = e;
    }
}

bool JointTree::add_link(int body, int parent, int block, LinkJoint joint, bool is_body1)
{
    if (link_of_body_[std::size_t(body)] >= 0) return false;
    TreeLink& link = links_[std::size_t(count_)];
    link = {.body = body,
            .parent = parent,
            .root = parent < 0 ? count_ : links_[std::size_t(parent)].root,
            .block = block,
            .first = dofs_,
            .count = dof_count(joint),
            .joint = joint,
            .is_body1 = is_body1,
            .from_root = {},
            .anchor = {}};
    link_of_body_[std::size_t(body)] = count_++;
    int last = parent < 0 ? -1 : links_[std::size_t(parent)].last;
    for (int i = 0; i < link.count; ++i, ++dofs_) {
        up_[std::size_t(dofs_)] = last,
        depth_[std::size_t(dofs_)] = last < 0 ? 0 : depth_[std::size_t(last)] + 1;
        last = dofs_;
    }
    link.last = last;
    return true;
}

void JointTree::hang_on_world(const RowSystem& system, std::span<const LinkJoint> kinds)
{
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (kinds[k] == LinkJoint::kNone) continue;
        const RowBlock& block = system.blocks[k];
        if (!moves(system, block.body2))
            add_link(block.body1, -1, int(k), kinds[k], true);
        else if (!moves(system, block.body1))
            add_link(block.body2, -1, int(k), kinds[k], false);
    }
}

// Children of all links from this one on, theirs included.
void JointTree::grow(const RowSystem& system, std::span<const LinkJoint> kinds, int& done)
{
    for (; done < count_; ++done) {
        const TreeLink link = links_[std::size_t(done)];
        for (int e = edge_of_body_[std::size_t(link.body)]; e >= 0; e = next_edge_[std::size_t(e)]) {
            const RowBlock& block = system.blocks[std::size_t(e / 2)];
            const int other = e % 2 == 0 ? block.body2 : block.body1;
            if (e / 2 != link.block && moves(system, other))
                add_link(other, done, e / 2, kinds[std::size_t(e / 2)], e % 2 == 1);
        }
    }
}

const TreeLink* JointTree::branch(const RowSystem& system, int block) const
{
    const RowBlock& its = system.blocks[std::size_t(block)];
    for (const int body : {its.body1, its.body2}) {
        const int at = link_of_body(body);
        if (at >= 0 && link(at).block == block) return &link(at);
    }
    return nullptr;
}

void JointTree::place(const RowSystem& system, std::span<const Vec3> centres)
{
    for (TreeLink& link : links_) {
        const Vec3 O = centres[std::size_t(links_[std::size_t(link.root)].body)];
        link.from_root = centres[std::size_t(link.body)] - O;
        if (link.block >= 0) {
            const RowBlock& block = system.blocks[std::size_t(link.block)];
            link.anchor = centres[std::size_t(block.body1)] - O + block.arms.r1;
        }
        place_motions(system, link);
    }
}

void JointTree::place_motions(const RowSystem& system, const TreeLink& link)
{
    Spatial* const to = motions_.data() + link.first;
    const Row* const rows =
        link.block < 0 ? nullptr : &system.rows[std::size_t(system.blocks[std::size_t(link.block)].first)];
    switch (link.joint) {
        case LinkJoint::kFree:
            for (int i = 0; i < 3; ++i) to[i] = {{}, kUnit[i]}, to[3 + i] = {kUnit[i], {}};
            return;
        case LinkJoint::kBall:
            for (int i = 0; i < 3; ++i) to[i] = {kUnit[i], cross(link.anchor, kUnit[i])};
            return;
        case LinkJoint::kHinge: {
            const Vec3 axis = cross(rows[3].ang1, rows[4].ang1);
            to[0] = {axis, cross(link.anchor, axis)};
            return;
        }
        case LinkJoint::kSlider:
            to[0] = {{}, cross(rows[3].lin1, rows[4].lin1)};
            return;
        default:
            return;
    }
}

void JointTree::move(int index, Vec3 from_root, Vec3 anchor, std::span<const Spatial> motions)
{
    TreeLink& link = links_[std::size_t(index)];
    link.from_root = from_root, link.anchor = anchor;
    std::copy(motions.begin(), motions.end(), motions_.begin() + link.first);
}

void JointTree::velocities(std::span<const double> u, std::span<Spatial> of_links) const
{
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const TreeLink& link = links_[i];
        Spatial at_O = link.parent < 0 ? Spatial{} : scratch_[std::size_t(link.parent)];
        for (int k = link.first; k < link.first + link.count; ++k)
            at_O = at_O + Real(u[std::size_t(k)]) * motions_[std::size_t(k)];
        scratch_[i] = at_O;
        of_links[i] = {at_O.ang, at_O.lin + cross(at_O.ang, link.from_root)};
    }
}

void JointTree::gather(std::span<Spatial> of_links, std::span<double> out) const
{
    for (std::size_t i = 0; i < links_.size(); ++i)
        of_links[i] = about_root(links_[i], of_links[i].lin, of_links[i].ang);
    for (std::size_t i = links_.size(); i-- > 0;) {
        const TreeLink& link = links_[i];
        for (int k = link.first; k < link.first + link.count; ++k)
            out[std::size_t(k)] = double(dot(motions_[std::size_t(k)], of_links[i]));
        if (link.parent >= 0)
            of_links[std::size_t(link.parent)] = of_links[std::size_t(link.parent)] + of_links[i];
    }
}

}  // namespace epode
