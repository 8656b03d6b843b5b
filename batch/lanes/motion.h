// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From the root outwards: where links are, how they move, and the acceleration that they would have if no velocity changed,
//     V = V_parent + sum S v          A = A_parent + sum V_before x (S v),        A of the world = -gravity.
// A floating base's O moves with it, so that its own velocity (rdot, w) gives A = (0, rdot x w) instead.
// Source: Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 2 and 5.
#pragma once

#include "batch/lanes/angles.h"
#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

template <typename P>
EPODE_LANEWISE Mat3Of<P> matrix_of(const Vec4Of<P>& q)
{
    const P one(1), x = q.x + q.x, y = q.y + q.y, z = q.z + q.z;
    const P wx = q.w * x, wy = q.w * y, wz = q.w * z, xx = q.x * x, xy = q.x * y, xz = q.x * z, yy = q.y * y,
            yz = q.y * z, zz = q.z * z;
    return {{one - (yy + zz), xy - wz, xz + wy},
            {xy + wz, one - (xx + zz), yz - wx},
            {xz - wy, yz + wx, one - (xx + yy)}};
}

// V x (S v), both motions.
template <typename P>
EPODE_LANEWISE Spatial<P> crossed(const Spatial<P>& a, const Spatial<P>& b)
{
    return {cross(a.w, b.w), cross(a.w, b.v) + cross(a.v, b.w)};
}

// V x* f, a motion and a force.
template <typename P>
EPODE_LANEWISE Spatial<P> crossed_force(const Spatial<P>& a, const Spatial<P>& f)
{
    return {cross(a.w, f.w) + cross(a.v, f.v), cross(a.w, f.v)};
}

template <typename P, bool own>
struct Motion {
    const ModelView& model;
    Numbers<P, own> numbers;
    const P *q, *v;
    Work<P>& work;

    void find() const
    {
        LinkWork<P>& world = work.link[0];
        const P zero(0);
        world.q = {P(1), zero, zero, zero}, world.r = matrix_of(world.q), world.p = {zero, zero, zero};
        world.velocity = {world.p, world.p};
        const Vec3Of<P> g = numbers.vec(model.gravity);
        world.acceleration = {world.p, {-g.x, -g.y, -g.z}};
        work.origin[model.trees] = world.p;
        for (int i = 1; i < model.links.size(); ++i) find_link(i);
    }

    void find_link(int number) const
    {
        const BatchLink& link = model.links[number];
        const LinkWork<P>& parent = work.link[link.parent];
        LinkWork<P>& its = work.link[number];
        const Vec3Of<P> place = numbers.vec(link.first + link_number::kPlace);
        its.velocity = parent.velocity, its.acceleration = parent.acceleration;
        its.q = link.is_turned ? parent.q * numbers.quat(link.first + link_number::kTurn) : parent.q;
        if (link.parent == 0) {
            work.origin[link.tree] = place, its.p = {P(0), P(0), P(0)};
        } else {
            its.p = parent.p + parent.r * place;
        }
        its.r = link.is_turned ? matrix_of(its.q) : parent.r;
        for (int k = 0; k < link.joints; ++k) move(model.joints[link.first_joint + k], its, link.tree);
        find_inertia(link, its);
    }

    EPODE_LANEWISE void move(const BatchJoint& joint, LinkWork<P>& its, int tree) const
    {
        switch (joint.kind) {
            case JointKind::kHinge:
                return hinge(joint, its);
            case JointKind::kSlide:
                return slide(joint, its);
            case JointKind::kBall:
                return ball(joint, its);
            case JointKind::kFree:
                return floating(joint, its, tree);
        }
    }

    EPODE_LANEWISE void add_motion(int dof, const Spatial<P>& s, LinkWork<P>& its) const
    {
        work.s[dof] = s;
        const Spatial<P> moved = v[dof] * s;
        its.acceleration = its.acceleration + crossed(its.velocity, moved);
        its.velocity = its.velocity + moved;
    }

    void hinge(const BatchJoint& joint, LinkWork<P>& its) const
    {
        const Vec3Of<P> axis = numbers.vec(joint.first + joint_number::kAxis);
        const SineCosine<P> half =
            half_turn(q[joint.position] - numbers[joint.first + joint_number::kReference]);
        const Vec3Of<P> anchor = numbers.vec(joint.first + joint_number::kAnchor);
        const Vec3Of<P> at = joint.is_at_origin ? its.p : its.p + its.r * anchor;
        its.q = its.q * Vec4Of<P>{half.cosine, half.sine * axis.x, half.sine * axis.y, half.sine * axis.z};
        its.r = matrix_of(its.q);
        its.p = joint.is_at_origin ? at : at - its.r * anchor;
        const Vec3Of<P> w = its.r * axis;
        add_motion(joint.dof, {w, cross(at, w)}, its);
    }

    void slide(const BatchJoint& joint, LinkWork<P>& its) const
    {
        const Vec3Of<P> axis = its.r * numbers.vec(joint.first + joint_number::kAxis);
        its.p = its.p + (q[joint.position] - numbers[joint.first + joint_number::kReference]) * axis;
        add_motion(joint.dof, {{P(0), P(0), P(0)}, axis}, its);
    }

    // Its three axes are the link's, and turn with it: V_before x (S v) once, of all three.
    void ball(const BatchJoint& joint, LinkWork<P>& its) const
    {
        const Vec3Of<P> anchor = numbers.vec(joint.first + joint_number::kAnchor),
                        at = its.p + its.r * anchor;
        its.q = its.q * Vec4Of<P>{q[joint.position], q[joint.position + 1], q[joint.position + 2],
                                  q[joint.position + 3]};
        its.r = matrix_of(its.q);
        its.p = at - its.r * anchor;
        const Vec3Of<P> axes[3] = {{its.r.row0.x, its.r.row1.x, its.r.row2.x},
                                   {its.r.row0.y, its.r.row1.y, its.r.row2.y},
                                   {its.r.row0.z, its.r.row1.z, its.r.row2.z}};
        Spatial<P> moved{{P(0), P(0), P(0)}, {P(0), P(0), P(0)}};
        for (int k = 0; k < 3; ++k) {
            work.s[joint.dof + k] = {axes[k], cross(at, axes[k])};
            moved = moved + v[joint.dof + k] * work.s[joint.dof + k];
        }
        its.acceleration = its.acceleration + crossed(its.velocity, moved);
        its.velocity = its.velocity + moved;
    }

    // Velocities of the origin and about it, both in the world's axes (step.h turns the latter).
    void floating(const BatchJoint& joint, LinkWork<P>& its, int tree) const
    {
        const P *at = q + joint.position, *u = v + joint.dof, zero(0), one(1);
        work.origin[tree] = {at[0], at[1], at[2]};
        its.q = {at[3], at[4], at[5], at[6]};
        its.r = matrix_of(its.q), its.p = {zero, zero, zero};
        const Vec3Of<P> none{zero, zero, zero},
            axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
        for (int k = 0; k < 3; ++k)
            work.s[joint.dof + k] = {none, axes[k]}, work.s[joint.dof + 3 + k] = {axes[k], none};
        its.velocity = {{u[3], u[4], u[5]}, {u[0], u[1], u[2]}};
        its.acceleration.v = its.acceleration.v + cross(its.velocity.v, its.velocity.w);
    }

    // J about O = R J_c R' + m (c.c - c c'), and the force I A + V x* (I V).
    void find_inertia(const BatchLink& link, LinkWork<P>& its) const
    {
        const int first = link.first;
        const P m = numbers[first + link_number::kMass];
        const Vec3Of<P> c = its.p + its.r * numbers.vec(first + link_number::kCentre);
        const int i = first + link_number::kInertia;
        const Sym3Of<P> local{numbers[i],     numbers[i + 1], numbers[i + 2],
                              numbers[i + 3], numbers[i + 4], numbers[i + 5]};
        const Vec3Of<P> x = local * its.r.row0, y = local * its.r.row1, z = local * its.r.row2;
        const Vec3Of<P> h = m * c;
        const P xx = h.x * c.x, yy = h.y * c.y, zz = h.z * c.z;
        its.inertia.m = m, its.inertia.h = h;
        its.inertia.j = {dot(its.r.row0, x) + (yy + zz), dot(its.r.row1, y) + (xx + zz),
                         dot(its.r.row2, z) + (xx + yy), dot(its.r.row0, y) - h.x * c.y,
                         dot(its.r.row0, z) - h.x * c.z, dot(its.r.row1, z) - h.y * c.z};
        const Spatial<P> momentum = its.inertia * its.velocity;
        its.force = its.inertia * its.acceleration + crossed_force(its.velocity, momentum);
        if (!link.is_weightless) return;
        const Vec3Of<P> weight = m * numbers.vec(model.gravity);
        its.force = its.force + Spatial<P>{cross(c, weight), weight};
    }
};

}  // namespace
}  // namespace epode::batch
