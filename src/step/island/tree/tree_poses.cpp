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

// (d - 1) a
Vec3 turned_less(Quat d, Vec3 a)
{
    const Vec3 t = 2 * cross(d.vec(), a);
    return d.w * t + cross(d.vec(), t);
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

TreePoses::Place TreePoses::parent_of(const TreeLink& link) const
{
    return link.parent < 0 ? Place{{}, {1, 0, 0, 0}} : places_[std::size_t(link.parent)];
}

bool TreePoses::begin(const IslandWork& work, const JointTree& tree, Arena& arena)
{
    tree_ = &tree;
    const int links = int(tree.links().size());
    before_ = arena.take<Before>(links), places_ = arena.take<Place>(links);
    locals_ = arena.take<Local>(links);
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < before_.size(); ++i) {
        const Body& b = *work.island.bodies[std::size_t(tree.link(int(i)).body)];
        before_[i] = {b.position(), b.orientation()};
        locals_[i] = local(work, tree, tree.link(int(i)), i);
    }
    return true;
}

TreePoses::Local TreePoses::local(const IslandWork& work, const JointTree& tree, const TreeLink& link,
                                  std::size_t i) const
{
    Local out{};
    if (link.block < 0) return out;
    const RowBlock& block = work.system.blocks[std::size_t(link.block)];
    const Row* const rows = &work.system.rows[std::size_t(block.first)];
    const bool slides = link.joint == LinkJoint::kSlider, points = !slides;
    const Real sign = link.is_body1 ? 1 : -1;
    for (int k = slides ? 0 : 3; k < (slides ? 3 : lock_rows(link.joint)); ++k)
        out.turn += (sign * rows[k].error) * rows[k].ang1;
    if (link.count == 1) out.axis = slides ? tree.motion(link.first).lin : tree.motion(link.first).ang;
    const Vec3 gap = points ? Vec3{rows[0].error, rows[1].error, rows[2].error}
                            : rows[3].error * rows[3].lin1 + rows[4].error * rows[4].lin1;
    if (slides || link.joint == LinkJoint::kFixed) {
        out.way = sign * gap;
        if (points) out.way -= cross(out.turn, link.is_body1 ? block.arms.r1 : Vec3{});
        const Vec3 its = before_[i].x, parent = parent_before(link);
        if (link.is_body1)
            out.parents_arm = its - parent;
        else
            out.own_arm = parent - its;
    } else {
        set_arms(link, block, gap, i, out);
    }
    return out;
}

// Arms may meet half way between the anchors (joints/parts.cpp).
void TreePoses::set_arms(const TreeLink& link, const RowBlock& block, Vec3 gap, std::size_t i,
                         Local& out) const
{
    const Vec3 its = before_[i].x, parent = parent_before(link);
    const bool has_two = block.body2 >= 0;
    const Vec3 x1 = link.is_body1 ? its : parent, x2 = link.is_body1 ? parent : its;
    const Vec3 seen = has_two ? (x2 + block.arms.r2) - (x1 + block.arms.r1) : gap;
    const Vec3 half = Real(0.5) * (gap - seen);
    const Vec3 p1 = x1 + block.arms.r1 - half, p2 = has_two ? x2 + block.arms.r2 + half : p1 + gap;
    const Vec3 mine = link.is_body1 ? p1 : p2, others = link.is_body1 ? p2 : p1;
    out.own_arm = mine - its, out.parents_arm = others - parent, out.way = others - mine;
}

void TreePoses::go_all(std::span<const double> dq, bool closes)
{
    for (std::size_t i = 0; i < places_.size(); ++i) go(i, dq.data() + tree_->link(int(i)).first, closes);
}

void TreePoses::go(std::size_t i, const double* own, bool closes)
{
    const TreeLink& link = tree_->link(int(i));
    const auto three = [&](int k) { return Vec3{Real(own[k]), Real(own[k + 1]), Real(own[k + 2])}; };
    Place& to = places_[i];
    if (link.joint == LinkJoint::kFree) {
        to = {three(0), turn_by(three(3))};
        return;
    }
    const Place parent = parent_of(link);
    const Local& l = locals_[i];
    Vec3 turn, way;
    if (link.joint == LinkJoint::kHinge) turn = Real(own[0]) * l.axis;
    if (link.joint == LinkJoint::kBall) turn = three(0);
    if (link.joint == LinkJoint::kSlider) way = Real(own[0]) * l.axis;
    if (closes) turn += l.turn, way += l.way;
    to.d = turn == Vec3{} ? parent.d : parent.d * turn_by(turn);
    to.y = parent.y + turned_less(parent.d, l.parents_arm) - turned_less(to.d, l.own_arm);
    if (link.joint == LinkJoint::kSlider || closes) to.y += way + turned_less(parent.d, way);
}

Spatial TreePoses::displacement(int link) const
{
    const Place& its = places_[std::size_t(link)];
    return {turn_of(its.d), its.y};
}

Quat TreePoses::orientation(int link) const
{
    Quat q = places_[std::size_t(link)].d * before(link).q;
    normalize(q);
    return q;
}

void TreePoses::store(int link, Body& to) const
{
    const Quat q = orientation(link);
    epode::store(to.pos, position(link)), store_quat(to.q, q), store_mat(to.R, to_matrix(q));
}

void TreePoses::move(JointTree& tree) const
{
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const TreeLink link = tree.link(int(i));
        const Vec3 x = position(int(i)), from_root = x - position(link.root);
        if (link.joint == LinkJoint::kFree) {
            tree.move(int(i), from_root, {}, {});
            continue;
        }
        const Local& l = locals_[i];
        const Vec3 anchor = from_root + l.own_arm + turned_less(places_[i].d, l.own_arm);
        const Vec3 axis = l.axis + turned_less(parent_of(link).d, l.axis);
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
