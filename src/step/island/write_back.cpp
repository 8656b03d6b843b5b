// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Feedback is the sum of J^T p over h, the mean force of the step; that of body 2 is left alone when there is none, as
// ODE does.
#include "step/island/write_back.h"

#include <atomic>

#include "joints/breaking.h"
#include "joints/coupling.h"
#include "joints/drive_rows.h"
#include "rows/wrench.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

void write_feedback(const Joint& joint, const RowBlock& block, const RowSystem& system)
{
    const BlockWrench mean = wrench_of(system, block, 1 / system.h);
    store(joint.feedback->f1, mean.f1);
    store(joint.feedback->t1, mean.t1);
    if (!joint.body2()) return;
    store(joint.feedback->f2, mean.f2);
    store(joint.feedback->t2, mean.t2);
}

void write_feedback(const Joint& joint, const JointManifold& m, const JointManifoldPoint& point, Real h)
{
    const Vec3 f = (1 / h) * (point.p[0] * m.n + point.p[1] * m.t1 + point.p[2] * m.t2);
    store(joint.feedback->f1, f);
    store(joint.feedback->t1, cross(point.r1, f));
    if (!joint.body2()) return;
    store(joint.feedback->f2, -f);
    store(joint.feedback->t2, -cross(point.r1 + m.offset, f));
}

void keep_impulses(Joint& joint, const RowBlock& block, const RowSystem& system)
{
    for (int i = 0; i < block.count; ++i) impulses(joint)[i] = system.numbers[std::size_t(block.first + i)].p;
    joint.impulse_rows = std::uint8_t(block.count);
    lasting(joint).impulse_step = system.h;
}

// f(coupling, block)
template <typename F>
void for_each_coupling(const IslandWork& work, F&& f)
{
    for (std::size_t k = 0; k < work.joints.size(); ++k)
        if (work.system.blocks[k].term_count > 0) f(coupling_of(*work.joints[k]), work.system.blocks[k]);
}

void write_joints(const IslandWork& work)
{
    const bool coupled = !work.system.terms.empty();
    if (coupled)
        for_each_coupling(
            work, [](CouplingJoint& coupling, const RowBlock&) { clear_feedback_of_members(coupling); });
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        Joint& joint = *work.joints[k];
        const RowBlock& block = work.system.blocks[k];
        if (!block.contact) keep_impulses(joint, block, work.system);
        if (joint.driven) store_drive_forces(joint, block, work.system), add_load(joint, block, work.system);
        if (joint.feedback) write_feedback(joint, block, work.system);
    }
    if (coupled)
        for_each_coupling(work, [&](CouplingJoint& coupling, const RowBlock& block) {
            coupling.force = 0;
            for (int i = block.first; i < block.first + block.count; ++i)
                coupling.force += work.system.numbers[std::size_t(i)].p / work.system.h;
            add_feedback_of_members(coupling);
        });
}

bool is_sound(const SolverBody& b)
{
    const Vec3 sum = abs(b.v) + abs(b.w);  // what is not a number stays so
    return usable(sum.x + sum.y + sum.z);
}

bool is_sound(const ContactManifold& manifold)
{
    if (manifold.special() &&
        !usable(Real(manifold.rolling_impulse.x + manifold.rolling_impulse.y + manifold.rolling_impulse.z)))
        return false;
    for (int i = 0; i < manifold.count; ++i)
        if (!usable(Real(manifold.points[i].normal_impulse))) return false;
    return true;
}

}  // namespace

bool sound(const RowSystem& system, int part, const Tasks& tasks)
{
    const SystemPart from = system.begin_of(part), to = system.end_of(part);
    std::atomic<bool> all{true};
    const auto check = [&](int first, int last, auto&& usable_at) {
        tasks.in_ranges(last - first, kObjectRange, [&](int begin, int end) {
            for (int i = first + begin; i < first + end; ++i)
                if (!usable_at(std::size_t(i))) return all.store(false, std::memory_order_relaxed);
        });
    };
    check(from.bodies, to.bodies, [&](std::size_t i) { return is_sound(system.bodies[i]); });
    check(from.contact_manifolds, to.contact_manifolds,
          [&](std::size_t i) { return is_sound(*system.contact_manifolds[i]); });
    if (!all) return false;
    if (from.blocks < to.blocks) {
        const RowBlock &first = system.blocks[std::size_t(from.blocks)],
                       &last = system.blocks[std::size_t(to.blocks) - 1];
        for (int i = first.first; i < last.first + last.count; ++i)
            if (!usable(system.numbers.data()[i].p)) return false;
    }
    for (auto k = std::size_t(from.joint_manifolds); k < std::size_t(to.joint_manifolds); ++k) {
        const JointManifold& m = system.joint_contacts.manifolds[k];
        for (int i = m.first; i < m.first + m.count; ++i)
            if (!usable(system.joint_contacts.points[std::size_t(i)].p, 3)) return false;
    }
    return true;
}

void write_back(const IslandWork& work, const Tasks& tasks)
{
    tasks.each_of(int(work.system.bodies.size()), kObjectRange, [&](std::size_t i) {
        store(work.island.bodies[i]->lvel, work.system.bodies[i].v);
        store(work.island.bodies[i]->avel, work.system.bodies[i].w);
    });
    write_joints(work);
    if (!work.contact_feedback) return;
    const JointManifoldList& list = work.system.joint_contacts;
    for (const JointManifold& m : list.manifolds)
        for (auto i = std::size_t(m.first); i < std::size_t(m.first + m.count); ++i)
            if (work.contacts[i]->feedback)
                write_feedback(*work.contacts[i], m, list.points[i], work.system.h);
}

void write_joints_again(const IslandWork& work)
{
    for (Joint* joint : work.joints)
        if (joint->driven) forget_load(*joint);
    write_joints(work);
}

}  // namespace epode
