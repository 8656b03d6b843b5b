// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What can be observed of a group: a function of its rows alone, so that it can be had at any time and costs nothing where nobody asks.
// Of the state: where links are and how they move, their inertias about C, the centre of mass of their tree, all in the world's axes;
// forces of actuators. Of the last step: forces of contacts and loops on links, torques about C, and of all constraints along dofs,
//     J' f = S . (forces on the subtree) + limits + dry friction + couplings + limits of tendons,
// with the poses and velocities in which that step began, for there they acted. Sums about O (work.h) become sums about C by
//     v_C = v_O + w x c,     t_C = t_O - c x f,     J_C = J_O - m (x.x - x x') + m (d.d - d d'),    x = h / m,  d = x - c,  c = C - O.
#pragma once

#include "batch/lanes/drives.h"
#include "batch/lanes/group.h"
#include "batch/lanes/mass.h"
#include "batch/lanes/motion.h"
#include "batch/lanes/observed.h"
#include "batch/lanes/rows.h"

namespace epode::batch {
namespace {

template <typename P>
EPODE_LANEWISE void put(P* to, const Vec3Of<P>& a)
{
    to[0] = a.x, to[1] = a.y, to[2] = a.z;
}

template <typename P, bool own>
struct Observe {
    using T = typename P::Number;
    const ModelView& model;
    const StepOptions& options;
    Numbers<P, own> numbers;
    Work<P>& work;
    P *q, *v, *control, *applied, *forces, *activations, *before, *before_v;  // rows of the group
    P* out;

    void find(int what) const
    {
        if (what & kOfState) {
            Motion<P, own>{model, numbers, q, v, work}.find();
            find_links();
            find_actuators();
        }
        if (what & kOfStep) {
            Motion<P, own>{model, numbers, before, before_v, work}.find();
            gather_subtrees(model, work);
            find_contacts();
            find_constraints();
        }
    }

    ObservedLayout to() const { return ObservedLayout(model); }

    int root_of(int link) const
    {
        while (model.links[link].parent != 0) link = model.links[link].parent;
        return link;
    }

    // C of the link's tree, from its O; once subtrees are gathered.
    Vec3Of<P> centre_of(int link) const
    {
        const Inertia<P>& all = work.link[root_of(link)].inertia;
        return inverse_or_zero(all.m) * all.h;
    }

    void find_links() const
    {
        const ObservedLayout at = to();
        for (int i = 0; i < model.links.size(); ++i) put_pose(i, at);
        for (int k = 0; k < 10; ++k) out[at.inertia + k] = P(0);
        for (int i = 1; i < model.links.size(); ++i)
            put_inertia(work.link[i].inertia, out + at.inertia + 10 * i);
        gather_subtrees(model, work);
        find_centre(out + at.centre);
        for (int k = 0; k < 6; ++k) out[at.velocity + k] = P(0);
        for (int i = 1; i < model.links.size(); ++i) {
            const Vec3Of<P> c = centre_of(i);
            const Spatial<P>& its = work.link[i].velocity;
            put(out + at.velocity + 6 * i, its.w),
                put(out + at.velocity + 6 * i + 3, its.v + cross(its.w, c));
            move_inertia(c, out + at.inertia + 10 * i);
        }
    }

    void put_pose(int i, const ObservedLayout& at) const
    {
        const LinkWork<P>& its = work.link[i];
        const Vec3Of<P> o = work.origin[i == 0 ? model.trees : model.links[i].tree];
        put(out + at.position + 3 * i, i == 0 ? o : its.p + o);
        P* turn = out + at.turn + 4 * i;
        turn[0] = its.q.w, turn[1] = its.q.x, turn[2] = its.q.y, turn[3] = its.q.z;
    }

    // As MuJoCo orders it: xx yy zz xy xz yz, mass times place, mass.
    EPODE_LANEWISE void put_inertia(const Inertia<P>& its, P* row) const
    {
        row[0] = its.j.xx, row[1] = its.j.yy, row[2] = its.j.zz;
        row[3] = its.j.xy, row[4] = its.j.xz, row[5] = its.j.yz;
        put(row + 6, its.h), row[9] = its.m;
    }

    EPODE_LANEWISE void move_inertia(const Vec3Of<P>& c, P* row) const
    {
        const P m = row[9], inverse = inverse_or_zero(m);
        const Vec3Of<P> x{inverse * row[6], inverse * row[7], inverse * row[8]}, d = x - c;
        const P xx = m * (d.x * d.x - x.x * x.x), yy = m * (d.y * d.y - x.y * x.y),
                zz = m * (d.z * d.z - x.z * x.z);
        row[0] = row[0] + (yy + zz), row[1] = row[1] + (xx + zz), row[2] = row[2] + (xx + yy);
        row[3] = row[3] - m * (d.x * d.y - x.x * x.y), row[4] = row[4] - m * (d.x * d.z - x.x * x.z);
        row[5] = row[5] - m * (d.y * d.z - x.y * x.z);
        put(row + 6, m * d);
    }

    void find_centre(P* to_row) const
    {
        P mass(0);
        Vec3Of<P> sum{mass, mass, mass};
        for (int i = 1; i < model.links.size(); ++i) {
            if (model.links[i].parent != 0) continue;
            const Inertia<P>& tree = work.link[i].inertia;
            mass = mass + tree.m, sum = sum + (tree.m * work.origin[model.links[i].tree] + tree.h);
        }
        put(to_row, inverse_or_zero(mass) * sum);
    }

    Drives<P, own> drives(const P* positions, double h) const
    {
        return {model, numbers, positions, v, control, applied, activations, P(T(h)), work};
    }
    Sums<P, own> sums() const { return {model, numbers, options, q, v, forces, work}; }

    // What they give in this state, held or clipped as in a step of no length; but early filters look as far ahead as a step does.
    void find_actuators() const
    {
        const Drives<P, own> now = drives(q, 0), next = drives(q, options.h);
        for (int i = 0; i < model.velocities; ++i) work.torque[i] = work.added[i] = P(0);
        for (int i = 0; i < model.servos; ++i) work.servos[i] = {P(0), P(0), P(0)};
        for (int i = 0; i < model.sums.size(); ++i)
            work.sums[i] = {now.length_of(model.sums[i]), {P(0), P(0), P(0)}, P(0)};
        for (int i = 0; i < model.actuators.size(); ++i) {
            const BatchActuator& its = model.actuators[i];
            now.actuate(its, next.input(its, control[i]), work.servos);
        }
        for (int i = 0; i < model.sums.size(); ++i)
            if (model.sums[i].drive >= 0) now.spread(model.sums[i], pull_of(i), work.torque);
        for (int i = 0; i < model.velocities; ++i) {
            const Dof& dof = model.dofs[i];
            P force = work.torque[i];
            if (dof.servo >= 0) {
                const P most = numbers[dof.first + dof_number::kForceLimit];
                const ServoWork<P>& its = work.servos[dof.servo];
                force = force + clip(its.force - its.gain * v[i], -most, most);
            }
            out[to().actuator + i] = force;
        }
    }

    // Of the servos on a sum, whose limit a step holds together with the sum's own spring and damper.
    P pull_of(int i) const
    {
        const BatchSum& sum = model.sums[i];
        const P rate = sums().rate(sum), servos = work.sums[i].drive.force - work.sums[i].drive.gain * rate;
        SumWork<P> passive;
        drives(q, 0).measure(sum, passive);
        const P all = servos + (passive.drive.force - passive.drive.gain * rate),
                most = numbers[sum.first + sum_number::kForceLimit];
        return servos + (clip(all, -most, most) - all);
    }

    void find_contacts() const
    {
        const P zero(0);
        for (int i = 0; i < model.links.size(); ++i)
            work.link[i].force = {{zero, zero, zero}, {zero, zero, zero}};
        add_forces();
        P* rows = out + to().contact;
        for (int i = 0; i < model.links.size(); ++i) {
            const Spatial<P>& its = work.link[i].force;
            put(rows + 6 * i, i == 0 ? its.w : its.w - cross(centre_of(i), its.v));
            put(rows + 6 * i + 3, its.v);
        }
    }

    // To the forces on links, about O.
    void add_forces() const
    {
        points().place();
        for (const BatchPair& pair : model.pairs) touch(pair);
        for (const BatchLoop& loop : model.loops) tie(loop);
    }

    // What the loop has exerted on its links.
    void tie(const BatchLoop& loop) const
    {
        const Loops<P, own> loops{model, numbers, options, before, work};
        const P* f = forces + model.first_loop() + loop.row;
        const Vec3Of<P> force{f[0], f[1], f[2]};
        press(loop.link_a, loops.place(loop.link_a, loop.first_a), force);
        press(loop.link_b, loops.place(loop.link_b, loop.first_b), P(-1) * force);
        if (!loop.is_weld) return;
        const Vec3Of<P> torque{f[3], f[4], f[5]};
        twist(loop.link_a, torque), twist(loop.link_b, P(-1) * torque);
    }

    Points<P, own> points() const { return {model, numbers, options, work}; }

    void touch(const BatchPair& pair) const
    {
        const P* f = forces + 3 * pair.first_slot;
        P any(0);
        for (int k = 0; k < pair.slots; ++k) any = any + f[3 * k];
        if (!any_positive(any)) return;
        points().find(pair);
        const int a = model.shapes[pair.shape_a].link, b = model.shapes[pair.shape_b].link;
        const Vec3Of<P> apart =
            work.origin[points().tree_of(pair.shape_b)] - work.origin[points().tree_of(pair.shape_a)];
        for (int k = 0; k < pair.slots; ++k, f += 3) {
            const Vec3Of<P> force = force_of(pair, work.normals[k], f);
            press(a, work.points[k], force);
            press(b, work.points[k] - apart, P(-1) * force);
            if (pair.first_turn < 0) continue;
            const Vec3Of<P> torque =
                force_of(pair, work.normals[k], forces + model.first_turn() + 3 * (pair.first_turn + k));
            twist(a, torque), twist(b, P(-1) * torque);
        }
    }

    EPODE_LANEWISE Vec3Of<P> force_of(const BatchPair& pair, const Vec3Of<P>& normal, const P* f) const
    {
        if (pair.is_upright) return {f[1], f[2], f[0]};
        Vec3Of<P> one, two;
        tangents(normal, one, two);
        return f[0] * normal + f[1] * one + f[2] * two;
    }

    EPODE_LANEWISE void twist(int link, const Vec3Of<P>& torque) const
    {
        if (link != 0) work.link[link].force.w = work.link[link].force.w + torque;
    }

    EPODE_LANEWISE void press(int link, const Vec3Of<P>& at, const Vec3Of<P>& force) const
    {
        if (link == 0) return;
        Spatial<P>& sum = work.link[link].force;
        sum = sum + Spatial<P>{cross(at, force), force};
    }

    void find_constraints() const
    {
        for (int i = model.links.size(); i-- > 1;) {
            const int parent = model.links[i].parent;
            if (parent != 0) work.link[parent].force = work.link[parent].force + work.link[i].force;
        }
        P* rows = out + to().constraint;
        for (int i = 0; i < model.velocities; ++i)
            rows[i] = dot(work.s[i], work.link[model.dofs[i].link].force) + single(i);
        for (const BatchSum& sum : model.sums)
            if (sum.stop >= 0) drives(before, 0).spread(sum, stop_of(sum), rows);
        for (const BatchJoint& joint : model.joints)
            if (joint.kind == JointKind::kFree) {
                P* t = rows + joint.dof + 3;
                put(t, transposed_times(work.link[joint.link].r, Vec3Of<P>{t[0], t[1], t[2]}));
            }
    }

    // Of a coupling, or of a tendon's limit.
    P stop_of(const BatchSum& sum) const
    {
        const P force = forces[model.first_sum() + sum.stop];
        return sum.is_equality ? force : sums().nearer_end(sum, drives(before, 0).length_of(sum)) * force;
    }

    P single(int i) const
    {
        const Dof& dof = model.dofs[i];
        P sum(0);
        if (dof.dry >= 0) sum = forces[3 * model.slots + model.limits + dof.dry];
        if (dof.limit < 0) return sum;
        const P at = before[model.joints[dof.joint].position],
                below = at - numbers[dof.first + dof_number::kLow],
                above = numbers[dof.first + dof_number::kHigh] - at;
        return sum + if_greater(below, above, P(-1), P(1)) * forces[3 * model.slots + dof.limit];
    }
};

}  // namespace
}  // namespace epode::batch
