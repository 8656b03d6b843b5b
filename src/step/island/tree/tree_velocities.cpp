// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The end of a tree's step: velocities that its joints allow there, with the momenta of the way, and what its joints have exerted.
//
//   H1 u1 = T1^T (P, L) + sum j (j . u) / C,   v1 = T1 u1        j, C: of the rows that yield, u of the way
#include "step/island/tree/tree_motion.h"

namespace epode {

// Of each dof, how fast a link moves along it against its parent at the beginning.
void TreeMotion::find_rates(std::span<double> rates) const
{
    for (std::size_t i = 0; i < size_; ++i) {
        const TreeLink& link = tree_->link(int(i));
        Vec3 v = body(i).velocity(), w = body(i).angular_velocity();
        if (link.parent >= 0) {
            const Body& parent = body(std::size_t(link.parent));
            const Vec3 arm = link.from_root - tree_->link(link.parent).from_root;
            v -= parent.velocity() + cross(parent.angular_velocity(), arm), w -= parent.angular_velocity();
        }
        for (int k = link.first; k < link.first + link.count; ++k) {
            const Spatial& m = tree_->motion(k);
            const bool moves = m.ang == Vec3{};
            rates[std::size_t(k)] = double(moves ? dot(m.lin, v) : dot(m.ang, w));
        }
    }
}

bool TreeMotion::settle_velocities()
{
    Arena::Scope scope(*arena_);
    poses_.move(*tree_);
    TreeFactor factor;
    const auto inertias = arena_->take<Sym3>(int(size_));
    if (arena_->failed() || !factor.prepare(*tree_, *arena_)) return false;
    for (std::size_t i = 0; i < size_; ++i) inertias[i] = rotate(body(i).rotation(), body(i).inertia);
    std::size_t at = 0;
    factor.assemble(*tree_, [&](const TreeLink& link) {
        return LinkInertia{work_->system.bodies[std::size_t(link.body)].mass, inertias[at++]};
    });
    std::copy(momenta_.begin(), momenta_.end(), scratch_.begin());
    tree_->gather(scratch_, r_);
    const std::span<const double> rates = solve_->u();
    solve_->add_yields_to(factor), solve_->add_yield_momentum(rates, r_);
    factor.factor(), factor.solve(r_);
    const bool holds = closing_->hold(*solve_, factor, r_, *arena_);
    if (arena_->failed()) return false;
    solve_->add_yield_impulses(rates, r_);
    tree_->velocities(r_, scratch_);
    for (std::size_t i = 0; i < size_; ++i) {
        SolverBody& b = solver_body(i);
        b.v = scratch_[i].lin, b.w = scratch_[i].ang;
        store(body(i).lvel, b.v), store(body(i).avel, b.w);
        body(i).spin_excess = {};
        scratch_[i] = Spatial{inertias[i] * b.w, b.mass * b.v} - momenta_[i];
    }
    if (holds) closing_->subtract_impulses(*tree_, scratch_);
    add_last_impulses(scratch_);
    solve_->store_joint_impulses(impulses_);
    return true;
}

// What each joint hands on at the beginning, about its anchor: the change of momentum of all that hangs on it, less what rows exert.
void TreeMotion::find_joint_impulses()
{
    for (std::size_t i = 0; i < size_; ++i) impulses_[i] = momenta_[i] - before_[i];
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
