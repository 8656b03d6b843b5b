// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/tree/tree_poses.h"

#include <algorithm>

#include "math/trig.h"

namespace epode {
namespace {

// The turn by the rotation vector r. Series below 0.2 rad, to the last digit.
Quat turn_by(Vec3 r)
{
    const Real t = length2(r) / 4;
    if (t < Real(0.01)) {
        const Real s = 1 - t * (Real(1) / 6 - t * (Real(1) / 120 - t * (Real(1) / 5040 - t / 362880)));
        const Real c = 1 - t * (Real(1) / 2 - t * (Real(1) / 24 - t * (Real(1) / 720 - t / 40320)));
        const Vec3 v = (s / 2) * r;
        return {c, v.x, v.y, v.z};
    }
    const Real half = std::sqrt(t);
    const Vec3 v = (sinc(half) / 2) * r;
    return {epode::cos(half), v.x, v.y, v.z};
}

// And back, up to half a turn.
Vec3 turn_of(Quat q)
{
    const Vec3 v = q.w < 0 ? -q.vec() : q.vec();
    const Real t = length2(v);
    if (t < Real(0.0025))
        return (2 +
                t * (Real(1) / 3 + t * (Real(3) / 20 +
                                        t * (Real(5) / 56 + t * (Real(35) / 576 + t * (Real(63) / 1408)))))) *
               v;
    const Real s = std::sqrt(t);
    return (2 * epode::atan2(s, std::fabs(q.w)) / s) * v;
}

}  // namespace

TreePoses::Place TreePoses::parent_of(const TreeLink& link, std::span<const Place> places) const
{
    return link.parent < 0 ? Place{{}, {}, Mat3::identity()} : places[std::size_t(link.parent)];
}

bool TreePoses::begin(const IslandWork& work, const JointTree& tree, Arena& arena)
{
    tree_ = &tree;
    const int links = int(tree.links().size());
    before_ = arena.take<Place>(links), now_ = arena.take<Place>(links), locals_ = arena.take<Local>(links);
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < before_.size(); ++i) {
        const Body& b = *work.island.bodies[std::size_t(tree.link(int(i)).body)];
        before_[i] = {b.position(), b.orientation(), b.rotation()};
        locals_[i] = local(work, tree, tree.link(int(i)), i);
    }
    return true;
}

TreePoses::Local TreePoses::local(const IslandWork& work, const JointTree& tree, const TreeLink& link,
                                  std::size_t i) const
{
    Local out{};
    if (link.block < 0) return out;
    const Place its = before_[i], parent = parent_of(link, before_);
    const RowBlock& block = work.system.blocks[std::size_t(link.block)];
    const Row* const rows = &work.system.rows[std::size_t(block.first)];
    const bool slides = link.joint == LinkJoint::kSlider, points = !slides;
    const Real sign = link.is_body1 ? 1 : -1;
    out.relative = conjugate(parent.q) * its.q;
    Vec3 turn;  // of the link, in the world
    for (int k = slides ? 0 : 3; k < (slides ? 3 : lock_rows(link.joint)); ++k)
        turn += (sign * rows[k].error) * rows[k].ang1;
    out.turn = transposed_times(parent.R, turn);
    if (link.count == 1) {
        const Spatial& motion = tree.motion(link.first);
        out.axis = transposed_times(parent.R, slides ? motion.lin : motion.ang);
    }
    const Vec3 gap = points ? Vec3{rows[0].error, rows[1].error, rows[2].error}
                            : rows[3].error * rows[3].lin1 + rows[4].error * rows[4].lin1;
    if (slides || link.joint == LinkJoint::kFixed) {
        Vec3 way = sign * gap;
        if (points) way -= cross(turn, link.is_body1 ? block.arms.r1 : Vec3{});
        out.offset = transposed_times(parent.R, its.x - parent.x + way);
        if (!link.is_body1) out.own_anchor = transposed_times(its.R, parent.x - its.x);
        return out;
    }
    // Arms may meet half way between the anchors (joints/parts.cpp).
    const bool has_two = block.body2 >= 0;
    const Vec3 x1 = link.is_body1 ? its.x : parent.x, x2 = link.is_body1 ? parent.x : its.x;
    const Vec3 seen = has_two ? (x2 + block.arms.r2) - (x1 + block.arms.r1) : gap;
    const Vec3 half = Real(0.5) * (gap - seen);
    const Vec3 p1 = x1 + block.arms.r1 - half, p2 = has_two ? x2 + block.arms.r2 + half : p1 + gap;
    const Vec3 mine = link.is_body1 ? p1 : p2, others = link.is_body1 ? p2 : p1;
    out.own_anchor = transposed_times(its.R, mine - its.x);
    out.anchor = transposed_times(parent.R, others - parent.x);
    return out;
}

void TreePoses::go(std::span<const double> dq)
{
    for (std::size_t i = 0; i < now_.size(); ++i) go(i, dq.data());
}

void TreePoses::go(std::size_t i, const double* dq)
{
    const TreeLink& link = tree_->link(int(i));
    const double* const own = dq + link.first;
    Place& to = now_[i];
    if (link.joint == LinkJoint::kFree) {
        to.x = before_[i].x + Vec3{Real(own[0]), Real(own[1]), Real(own[2])};
        to.q = turn_by({Real(own[3]), Real(own[4]), Real(own[5])}) * before_[i].q;
    } else {
        const Place parent = parent_of(link, now_);
        const Local& l = locals_[i];
        Vec3 turn = l.turn;
        if (link.joint == LinkJoint::kHinge) turn += Real(own[0]) * l.axis;
        if (link.joint == LinkJoint::kBall)
            turn +=
                transposed_times(parent_of(link, before_).R, Vec3{Real(own[0]), Real(own[1]), Real(own[2])});
        to.q = parent.q * (turn_by(turn) * l.relative);
        if (link.joint == LinkJoint::kSlider)
            to.x = parent.x + parent.R * (l.offset + Real(own[0]) * l.axis);
        else if (link.joint == LinkJoint::kFixed)
            to.x = parent.x + parent.R * l.offset;
        else
            to.x = parent.x + parent.R * l.anchor;
    }
    normalize(to.q);
    to.R = to_matrix(to.q);
    if (link.joint == LinkJoint::kHinge || link.joint == LinkJoint::kBall)
        to.x -= to.R * locals_[i].own_anchor;
}

Spatial TreePoses::displacement(int link) const
{
    const Place &from = before_[std::size_t(link)], &to = now_[std::size_t(link)];
    return {turn_of(to.q * conjugate(from.q)), to.x - from.x};
}

void TreePoses::move(JointTree& tree) const
{
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const TreeLink link = tree.link(int(i));
        const Place& its = now_[i];
        const Vec3 O = now_[std::size_t(link.root)].x, from_root = its.x - O;
        if (link.joint == LinkJoint::kFree) {
            tree.move(int(i), from_root, {}, {});
            continue;
        }
        const Vec3 anchor = from_root + its.R * locals_[i].own_anchor;
        const Vec3 axis = parent_of(link, now_).R * locals_[i].axis;
        Spatial motions[3];
        if (link.joint == LinkJoint::kHinge) motions[0] = {axis, cross(anchor, axis)};
        if (link.joint == LinkJoint::kSlider) motions[0] = {{}, axis};
        if (link.joint == LinkJoint::kBall)
            for (int k = 0; k < 3; ++k) {
                Vec3 unit;
                unit.set(k, 1);
                motions[k] = {unit, cross(anchor, unit)};
            }
        tree.move(int(i), from_root, anchor, {motions, std::size_t(link.count)});
    }
}

}  // namespace epode
