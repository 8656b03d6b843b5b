// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "solve/substeps/substep_solver.h"

#include <algorithm>

#include "rows/wrench.h"
#include "solve/common/residual.h"
#include "solve/substeps/impacts/restitution.h"

namespace epode {

template <typename Joints>
bool SubstepSolver<Joints>::prepare(const SubstepSettings& settings, Arena& arena)
{
    const Real share = Real(1) / Real(step_.n);
    for (RowNumbers& n : system_.numbers) {
        n.p *= share;
        if (n.parent < 0) n.lo *= share, n.hi *= share;
    }
    part_residuals_ = settings.part_residuals;
    velocities_ = take_velocities(system_, arena);
    if (velocities_.empty() || !joints_.pack(system_, arena)) return false;
    load_velocities(system_, velocities_);
    if (!joints_.follow(system_, step_, velocities_, arena)) return false;
    if (!contacts_.prepare(system_, step_, settings.seed, arena)) return false;
    if (!manifolds_.prepare(system_, step_, settings.tasks, arena)) return false;
    if (settings.want_residual) {
        before_ = arena.take<SolverBody>(int(system_.bodies.size()));
        lo_ = arena.take<Real>(int(system_.numbers.size()));
        hi_ = arena.take<Real>(int(system_.numbers.size()));
    }
    return (!settings.want_residual && system_.wrenches.empty()) || take_scratch(arena);
}

// Rows and numbers for joints to describe themselves in.
template <typename Joints>
bool SubstepSolver<Joints>::take_scratch(Arena& arena)
{
    described_ = arena.take<RowNumbers>(int(system_.numbers.size()));
    rows_ = arena.take<Row>(int(system_.rows.size()));
    summed_ = arena.take_zeroed<Real>(int(system_.rows.size()));
    if (arena.failed()) return false;
    std::copy(system_.numbers.begin(), system_.numbers.end(), described_.begin());
    std::copy(system_.rows.begin(), system_.rows.end(), rows_.begin());
    return true;
}

template <typename Joints>
bool SubstepSolver<Joints>::expect_rebounds(std::span<Velocity> pushed, Arena& arena)
{
    const std::span<Velocity> by_forces = pushed;
    for (std::size_t i = 0; i < by_forces.size(); ++i)
        by_forces[i].v -= velocities_[i].v, by_forces[i].w -= velocities_[i].w;
    for (int part = 0; part < system_.worlds(); ++part)
        if (hangs(part))
            for (int i = system_.begin_of(part).bodies; i < system_.end_of(part).bodies; ++i)
                by_forces[std::size_t(i)] = {};
    manifolds_.expect_impacts(system_, by_forces);
    return !contacts_.may_rebound(system_) ||
           contacts_.expect_rebounds(system_, velocities_, by_forces, arena);
}

// Do its joints hold it, so that forces do not tell how it falls?
template <typename Joints>
bool SubstepSolver<Joints>::hangs(int part) const
{
    const auto fixed = [&](int body) {
        return body < 0 || !(system_.bodies[std::size_t(body)].inv_mass > 0);
    };
    const auto first = system_.blocks.begin() + system_.begin_of(part).blocks;
    const auto last = system_.blocks.begin() + system_.end_of(part).blocks;
    return std::any_of(first, last, [&](const RowBlock& block) {
        return !block.contact && (block.term_count > 0 || fixed(block.body1) || fixed(block.body2));
    });
}

template <typename Joints>
void SubstepSolver<Joints>::begin()
{
    for (RowNumbers& n : system_.numbers) n.p = 0;  // from here on the sum
    joints_.turn(system_);
}

template <typename Joints>
void SubstepSolver<Joints>::begin_judged()
{
    store_velocities(velocities_, system_);
    std::copy(system_.bodies.begin(), system_.bodies.end(), before_.begin());
}

template <typename Joints>
void SubstepSolver<Joints>::correct()
{
    joints_.load_substep(system_, step_);
    joints_.apply_impulses(velocities_);
    contacts_.apply_impulses(velocities_);
    manifolds_.apply_impulses(velocities_);
    if (Joints::kHasBothEnds) joints_.sweep(velocities_, {1, false});
    contacts_.sweep(velocities_, false);
    manifolds_.correct(velocities_);
    joints_.sweep(velocities_, {1, false});  // the velocities that poses follow
}

template <typename Joints>
bool SubstepSolver<Joints>::judge(SolveReport& report, Arena& arena)
{
    std::copy(system_.rows.begin(), system_.rows.end(), rows_.begin());
    joints_.describe(described_, rows_);
    contacts_.describe(described_);
    RowSystem one = system_;
    one.numbers = described_, one.rows = rows_;
    one.frictions = contacts_.manifold_frictions(arena);
    const RowSystem all = one;
    manifolds_.apply_impulses(before_);
    present_bounds(one, lo_, hi_);
    report.residual = natural_residual(one, before_, lo_, hi_, arena);
    for (int part = 0; part < int(system_.parts.size()) && report.residual >= 0; ++part) {
        const int from = system_.begin_of(part).blocks, to = system_.end_of(part).blocks;
        one.blocks = system_.blocks.subspan(std::size_t(from), std::size_t(to - from));
        one.frictions = frictions_of(all, part);
        part_residuals_[std::size_t(part)] = natural_residual(one, before_, lo_, hi_, arena);
    }
    return report.residual >= 0;
}

template <typename Joints>
void SubstepSolver<Joints>::follow_motion()
{
    contacts_.follow_motion(velocities_);
    manifolds_.follow_motion(velocities_);
    add_joint_wrenches();
}

template <typename Joints>
void SubstepSolver<Joints>::relax()
{
    joints_.sweep(velocities_, {1, true});
    contacts_.sweep(velocities_, true);
    manifolds_.relax(velocities_);
    if (Joints::kHasBothEnds) joints_.sweep(velocities_, {1, true});
}

template <typename Joints>
void SubstepSolver<Joints>::end(bool last)
{
    if (last) joints_.apply_restitution(system_, velocities_);
    add_joint_wrenches();
    joints_.sum_impulses();
    contacts_.add_impulses(system_.numbers);
    std::fill(summed_.begin(), summed_.end(), Real(0));
}

// What joints have exerted since this was called last in the substep, where they are now: before poses
// change and when the substep ends. Rows that are followed have a pose of their own, the others that of
// the system.
template <typename Joints>
void SubstepSolver<Joints>::add_joint_wrenches()
{
    if (system_.wrenches.empty()) return;
    joints_.describe(described_, rows_);
    for (const RowBlock& block : system_.blocks) {
        if (block.wrench < 0 || block.contact) continue;
        for (int i = block.first; i < block.first + block.count; ++i) {
            const auto at = std::size_t(i);
            add_wrench(block, i, block.followed ? rows_[at] : system_.rows[at],
                       described_[at].p - summed_[at]);
            summed_[at] = described_[at].p;
        }
    }
}

template <typename Joints>
void SubstepSolver<Joints>::store()
{
    joints_.store_sums(system_.numbers);
    store_velocities(velocities_, system_);
}

// Once, with the sums: their arms do not change.
template <typename Joints>
void SubstepSolver<Joints>::add_contact_wrenches()
{
    for (const RowBlock& block : system_.blocks) {
        if (block.wrench < 0 || !block.contact) continue;
        for (int i = block.first; i < block.first + block.count; ++i)
            add_wrench(block, i, system_.rows[std::size_t(i)], system_.numbers[std::size_t(i)].p);
    }
}

template <typename Joints>
void SubstepSolver<Joints>::add_wrench(const RowBlock& block, int i, const Row& row, Real p)
{
    system_.wrenches[std::size_t(block.wrench)].add(block, i, row, p);
}

template <typename Joints>
bool SubstepSolver<Joints>::finish(Arena& arena)
{
    manifolds_.store_impulses(system_.contact_manifolds);
    std::span<float> rebounds;
    if (!manifolds_.find_rebounds(system_.contact_manifolds, arena, rebounds)) return false;
    contacts_.correct_rebounds(system_);
    Restitution restitution(system_, rebounds);
    if (!restitution.any()) return true;
    if (rows_.empty() && !take_scratch(arena)) return false;
    joints_.describe(described_, rows_);
    return restitution.apply(rows_, arena);
}

template class SubstepSolver<JointLanes>;
template class SubstepSolver<JointNetwork>;

}  // namespace epode
