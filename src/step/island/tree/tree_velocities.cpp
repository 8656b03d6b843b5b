// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The end of a tree's step: velocities that its joints allow there, and what its joints have exerted.
//
//   H1 u1 = T1^T M1 v' + sum j (j . rates of v') / C,   v1 = T1 u1
//
// A spin under exact rotation is that of the middle of the step (dynamics/exact_spin.cpp); joints see it with half of what it lacks, and
// the momentum that it has with the rest turns with the body.
#include "dynamics/exact_spin.h"
#include "step/island/tree/tree_motion.h"

namespace epode {

void TreeMotion::turn_excess() const
{
    for (std::size_t i = 0; i < size_; ++i) {
        Body& b = body(i);
        if (b.spin_excess == Vec3{}) continue;
        const Mat3& R0 = poses_.rotation_before(int(i));
        const Vec3 middle = b.inertia * transposed_times(R0, solver_body(i).w);
        b.spin_excess = transposed_times(poses_.rotation(int(i)), R0 * (middle + b.spin_excess)) - middle;
    }
}

Spatial TreeMotion::seen(std::size_t i) const
{
    const Body& b = body(i);
    Vec3 w = solver_body(i).w;
    if (!(b.spin_excess == Vec3{})) w += Real(0.5) * (b.rotation() * (b.inv_inertia * b.spin_excess));
    return {w, solver_body(i).v};
}

// Of each dof, how fast a link moves along it against its parent.
void TreeMotion::find_rates(std::span<double> rates) const
{
    for (std::size_t i = 0; i < size_; ++i) {
        const TreeLink& link = tree_->link(int(i));
        Spatial v = seen(i);
        if (link.parent >= 0) {
            const Spatial parent = seen(std::size_t(link.parent));
            const Vec3 arm = link.from_root - tree_->link(link.parent).from_root;
            v = v - Spatial{parent.ang, parent.lin + cross(parent.ang, arm)};
        }
        for (int k = link.first; k < link.first + link.count; ++k) {
            const Spatial& m = tree_->motion(k);
            rates[std::size_t(k)] =
                double(link.joint == LinkJoint::kSlider ? dot(m.lin, v.lin) : dot(m.ang, v.ang));
        }
    }
}

bool TreeMotion::settle_velocities()
{
    Arena::Scope scope(*arena_);
    turn_excess();
    poses_.move(*tree_);
    TreeFactor factor;
    const auto inertias = arena_->take<Sym3>(int(size_));
    if (arena_->failed() || !factor.prepare(*tree_, *arena_)) return false;
    for (std::size_t i = 0; i < size_; ++i) {
        const Spatial v = seen(i);
        inertias[i] = rotate(body(i).rotation(), body(i).inertia);
        scratch_[i] = {inertias[i] * v.ang, solver_body(i).mass * v.lin};
    }
    std::size_t at = 0;
    factor.assemble(*tree_, [&](const TreeLink& link) {
        return LinkInertia{work_->system.bodies[std::size_t(link.body)].mass, inertias[at++]};
    });
    tree_->gather(scratch_, r_);
    find_rates(dq_);
    solve_->add_yields_to(factor), solve_->add_yield_momentum(dq_, r_);
    factor.factor(), factor.solve(r_);
    solve_->add_yield_impulses(dq_, r_);
    tree_->velocities(r_, scratch_);
    for (std::size_t i = 0; i < size_; ++i) {
        const Spatial dv = scratch_[i] - seen(i);
        solver_body(i).v += dv.lin, solver_body(i).w += dv.ang;
        store(body(i).lvel, solver_body(i).v), store(body(i).avel, solver_body(i).w);
        scratch_[i] = {inertias[i] * dv.ang, solver_body(i).mass * dv.lin};
    }
    add_last_impulses(scratch_);
    solve_->store_joint_impulses(impulses_);
    return true;
}

// What each joint hands on at the beginning, about its anchor: the change of momentum of all that hangs on it, less what rows exert.
void TreeMotion::find_joint_impulses()
{
    for (std::size_t i = 0; i < size_; ++i) {
        const SolverBody& b = solver_body(i);
        impulses_[i] = {b.inertia * (b.w - before_[i].ang), b.mass * (b.v - before_[i].lin)};
    }
    solve_->subtract_impulses(impulses_);
    tree_->gather(impulses_, r_);
    for (std::size_t i = 0; i < size_; ++i)
        impulses_[i].ang -= cross(tree_->link(int(i)).anchor, impulses_[i].lin);
}

void TreeMotion::add_last_impulses(std::span<Spatial> changes)
{
    tree_->gather(changes, r_);
    for (std::size_t i = 0; i < size_; ++i) {
        changes[i].ang -= cross(tree_->link(int(i)).anchor, changes[i].lin);
        impulses_[i] = impulses_[i] + changes[i];
    }
}

}  // namespace epode
