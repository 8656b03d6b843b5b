// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every substep assembles the island again: joints evaluate their errors, the stops that act and their
// rebound at that moment, as if the program had made the step itself. Forces of the beginning are held
// constant, as far as constraints bear them. ERP and CFM of h become those of h/n for the same spring and damper
// (solve/common/substep_rows.h). Contacts are not searched again. Their separation follows the motion,
// error <- error - hs J v; one that has opened may close but not penetrate; those that touch rebound in every
// substep by its velocities. They act at one point of both bodies, half way between where the two have carried it, so that angular momentum
// is conserved. A joint's feedback is the mean of its forces over the substeps, which is the impulse of the
// step over h; so is what its drives report.
#include "step/steppers/exact_substeps.h"

#include <algorithm>

#include "dynamics/coupling.h"
#include "dynamics/joint_drives.h"
#include "rows/policy.h"
#include "rows/separating.h"
#include "solve/common/substep_rows.h"
#include "step/island/containment.h"
#include "step/island/positions/shake.h"
#include "step/island/positions/tension.h"
#include "step/island/problem/default_softness.h"
#include "step/island/prompt_forces.h"
#include "step/island/substep_model.h"
#include "step/island/write_back.h"

namespace epode {
namespace {

RowNumbers numbers_of(const Row& row, const Substep& step, Real inverse_mass, int block_first)
{
    RowNumbers n = ode_baumgarte(row, step.hs, block_first);
    if (row.drive) return take_drive(row, step.hs, n), n;
    const RowAim aim = map_row(row, step, inverse_mass);
    n.C = aim.C;
    n.c = wanted_velocity(row, aim.rate);
    if (row.kind != RowKind::kNormal) return n;
    n.c = row.error < 0 ? row.error / step.hs : separating_target(row, n.c);
    return n;
}

// Both lists have the contacts in the same order.
template <typename Use>
void for_each_contact(RowSystem& a, RowSystem& b, const Use& use)
{
    std::size_t j = 0;
    for (RowBlock& block : a.blocks) {
        if (!block.contact) continue;
        while (j < b.blocks.size() && !b.blocks[j].contact) ++j;
        if (j == b.blocks.size()) return;
        use(block, b.blocks[j++]);
    }
}

// The contacts of `first`, brought to the present poses, take the place of those that `work` has assembled.
void carry_contacts(IslandWork& first, IslandWork& work)
{
    for_each_contact(first.system, work.system, [&](RowBlock& from, RowBlock& to) {
        const auto rows = first.system.rows.subspan(std::size_t(from.first), std::size_t(from.count));
        gather_contact(work.island, from, rows);
        to.arms = from.arms;
        const Row& now = work.system.rows[std::size_t(to.first)];
        rows[0].restitution_velocity = now.restitution_velocity;
        rows[0].has_restitution = now.has_restitution && rows[0].error >= 0;
        std::copy(rows.begin(), rows.end(), work.system.rows.begin() + to.first);
    });
}

void load_warm_start(IslandWork& first, IslandWork& work)
{
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        const Joint& joint = *work.joints[k];
        const RowBlock& block = work.system.blocks[k];
        if (block.contact || joint.impulse_rows != block.count) continue;
        for (int i = 0; i < block.count; ++i)
            work.system.numbers[std::size_t(block.first + i)].p = impulses(joint)[i];
    }
    for_each_contact(first.system, work.system, [&](const RowBlock& from, const RowBlock& to) {
        for (int i = 0; i < to.count; ++i)
            work.system.numbers[std::size_t(to.first + i)].p =
                first.system.numbers[std::size_t(from.first + i)].p;
    });
}

// How far the contacts are after the substep that `work` has solved, and what they carry.
void follow_contacts(IslandWork& first, IslandWork& work)
{
    for_each_contact(first.system, work.system, [&](const RowBlock& to, const RowBlock& from) {
        const SolverBody& a = work.system.bodies[std::size_t(from.body1)];
        const SolverBody* b = from.body2 < 0 ? nullptr : &work.system.bodies[std::size_t(from.body2)];
        Row& normal = first.system.rows[std::size_t(to.first)];
        normal.error -= work.system.h * row_velocity(work.system.rows[std::size_t(from.first)], a, b);
        for (int i = 0; i < from.count; ++i)
            first.system.numbers[std::size_t(to.first + i)].p =
                work.system.numbers[std::size_t(from.first + i)].p;
    });
}

// Of a joint of `work` among those of `first`.
int block_in(const IslandWork& first, const IslandWork& work, int block)
{
    if (block < 0) return -1;
    const auto at = std::find(first.joints.begin(), first.joints.end(), work.joints[std::size_t(block)]);
    return at == first.joints.end() ? -1 : int(at - first.joints.begin());
}

void add(SolveReport& sum, const SolveReport& one)
{
    sum.method = std::max(sum.method, one.method);
    if (one.unsolved_joints > 0 && one.residual >= sum.residual) sum.unsolved_joint = one.unsolved_joint;
    sum.unsolved_joints = std::max(sum.unsolved_joints, one.unsolved_joints);
    sum.residual = std::max(sum.residual, one.residual);
    sum.iterations += one.iterations;
    sum.factorisations += one.factorisations;
    sum.fallback |= one.fallback;
    sum.friction_error = std::max(sum.friction_error, one.friction_error);
}

}  // namespace

bool ExactSubsteps::begin()
{
    before_ = arena_.take<Before>(int(island_.bodies.size()));
    feedback_ = arena_.take<Feedback>(int(island_.joints.size()));
    if (arena_.failed()) {
        before_ = {};  // nothing was written there: there is nothing to undo
        return false;
    }
    for (std::size_t i = 0; i < before_.size(); ++i) {
        const Body& b = *island_.bodies[i];
        before_[i] = {b.velocity(), b.angular_velocity(), load(b.facc), load(b.tacc), {}, {}};
    }
    for (Feedback& f : feedback_) f = {};
    return true;
}

void ExactSubsteps::undo()
{
    run_.context.undo.restore_poses(island_.bodies);
    for (std::size_t i = 0; i < before_.size(); ++i) {
        Body& b = *island_.bodies[i];
        store(b.lvel, before_[i].v);
        store(b.avel, before_[i].w);
    }
}

void ExactSubsteps::map(RowSystem& system) const
{
    const Substep step{hs_, n_};
    for (const RowBlock& block : system.blocks) {
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            const Real inverse_mass = inverse_effective_mass(system, block, row, system.bodies);
            system.numbers[std::size_t(i)] = numbers_of(row, step, inverse_mass, block.first);
        }
    }
}

void ExactSubsteps::kick(Real warm_share)
{
    const std::span<const BorneForce> borne =
        kick_by_prompt_forces(world_, first_, hs_ * Real(n_), warm_share, arena_);
    for (std::size_t i = 0; i < borne.size(); ++i) {
        const Body& body = *island_.bodies[i];
        if (body.kinematic()) continue;
        const Vec3 force = force_on(world_, body) - borne[i].force,
                   torque = load(body.tacc) - borne[i].torque;
        SolverBody& to = first_.system.bodies[i];
        to.v -= (hs_ * to.inv_mass) * force, to.w -= hs_ * (to.inv_inertia * torque);
        Before& before = before_[i];
        before.force -= force, before.torque -= torque;
        before.moving_force = force, before.moving_torque = torque;
    }
}

bool ExactSubsteps::run(const ExactSettings& settings, ProjectionReport& projected)
{
    bool raised = run_.raised > 0;
    if (throws(first_)) return false;
    add_to_ledger(first_);
    follow_contacts(first_, first_);
    carry_out(first_, raised, settings);
    for (int i = 1; i < n_; ++i) {
        Arena::Scope scope(arena_);
        IslandWork work;
        if (!next(settings, work, raised)) return false;
        add_to_ledger(work);
        follow_contacts(first_, work);
        carry_out(work, raised, settings);
        if (i < n_ - 1 || world_.projection_iterations <= 0) continue;
        run_.correct_poses([&] {
            projected = project_poses(world_, work, settings.tasks, *settings.symbolic_cache, arena_);
        });
    }
    store_feedback();
    restore_forces();
    return true;
}

bool ExactSubsteps::throws(const IslandWork& work)
{
    if (!run_.is_free(0)) run_.correction_of_all = correctable(run_, work, hs_);
    return run_.correction_of_all < 1;
}

bool ExactSubsteps::next(const ExactSettings& settings, IslandWork& work, bool& raised)
{
    load_forces();
    work.island = island_;
    if (!assemble(world_, hs_, form_, Tasks(1), arena_, work, nullptr)) return false;
    limit_default_softness(world_, hs_, work.system);
    carry_contacts(first_, work);
    map(work.system);
    raised =
        !world_.acts_as_ode() && add_tension(work, work.system.bodies, hs_, kResolvedExactly, arena_) > 0;
    if (world_.projection_iterations > 0) leave_depth_to_projection(world_, work);
    load_warm_start(first_, work);
    SolveReport one;
    if (!solve_exactly(work.system, settings, arena_, one) || !sound(work.system, 0)) return false;
    if (throws(work)) return false;
    one.unsolved_joint = block_in(first_, work, one.unsolved_joint);
    add(run_.solved, one);
    return true;
}

// Assembling adds gravity and the joints' own forces to what the program has applied.
void ExactSubsteps::load_forces()
{
    for (std::size_t i = 0; i < before_.size(); ++i) {
        store(island_.bodies[i]->facc, before_[i].force);
        store(island_.bodies[i]->tacc, before_[i].torque);
    }
}

void ExactSubsteps::restore_forces() const
{
    for (std::size_t i = 0; i < before_.size(); ++i) {
        Body& body = *island_.bodies[i];
        store(body.facc, load(body.facc) + before_[i].moving_force);
        store(body.tacc, load(body.tacc) + before_[i].moving_torque);
    }
}

void ExactSubsteps::add_to_ledger(const IslandWork& work)
{
    if (!ledger_.wanted()) return;
    ledger_.load_motion();
    ledger_.add_solution(work, 0, false);
}

void ExactSubsteps::carry_out(IslandWork& work, bool raised, const ExactSettings& settings)
{
    write_back(work, Tasks(1));
    if (world_.projection_iterations <= 0 || raised)
        advance_poses(world_, work, hs_);
    else if (advance_closing(world_, work, settings.tasks, *settings.symbolic_cache, arena_))
        write_joints_again(work);
    add_feedback(work);
}

void ExactSubsteps::add_feedback(const IslandWork& work)
{
    std::size_t at = 0;
    for (const Joint* joint : work.joints) {
        while (island_.joints[at] != joint) ++at;
        Feedback& sum = feedback_[at];
        for (int i = 0; joint->driven && i < kMaxAxes; ++i) sum.drive[i] += drives_of(*joint).axis[i].force;
        if (is_coupling(*joint)) sum.coupling += coupling_of(*joint).force;
        if (!joint->feedback) continue;
        const dJointFeedback& now = *joint->feedback;
        sum.f1 += load(now.f1), sum.t1 += load(now.t1);
        if (joint->body2()) sum.f2 += load(now.f2), sum.t2 += load(now.t2);
        sum.any = true;
    }
}

void ExactSubsteps::store_feedback() const
{
    for (std::size_t k = 0; k < feedback_.size(); ++k) {
        const Feedback& sum = feedback_[k];
        Joint& joint = *island_.joints[k];
        for (int i = 0; joint.driven && i < kMaxAxes; ++i)
            drives_of(joint).axis[i].force = sum.drive[i] / Real(n_);
        if (is_coupling(joint)) coupling_of(joint).force = sum.coupling / Real(n_);
        if (!sum.any) continue;
        dJointFeedback& out = *joint.feedback;
        store(out.f1, sum.f1 / Real(n_)), store(out.t1, sum.t1 / Real(n_));
        if (!joint.body2()) continue;
        store(out.f2, sum.f2 / Real(n_)), store(out.t2, sum.t2 / Real(n_));
    }
}

}  // namespace epode
