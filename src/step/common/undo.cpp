// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands are pieces of two arrays that hold all bodies and all joints, which are gone through as a whole:
// a thousand islands of one body cost no more than one of a thousand.
#include "step/common/undo.h"

#include <algorithm>
#include <cstring>

#include "base/prefetch.h"

namespace epode {
namespace {

template <typename T, std::size_t N>
void copy(T (&to)[N], const T (&from)[N])
{
    std::memcpy(to, from, sizeof to);
}

// The array that the pieces make up, given the first and the last of them.
template <typename T>
std::span<T> joined(std::span<T> first, std::span<T> last)
{
    return {first.data(), last.data() + last.size()};
}

int numbers_of(const LastingJoint& joint) { return joint.impulse_rows + joint.mean_rows + 2; }

Real* take_memory(const LastingJoint& joint, Real* to)
{
    to = std::copy_n(joint.impulse, joint.impulse_rows, to);
    to = std::copy_n(joint.mean, joint.mean_rows, to);
    *to++ = joint.impulse_step, *to++ = joint.mean_time;
    return to;
}

// Its numbers of rows have been restored.
const Real* restore_memory(const Real* from, LastingJoint& joint)
{
    std::copy_n(from, joint.impulse_rows, joint.impulse), from += joint.impulse_rows;
    std::copy_n(from, joint.mean_rows, joint.mean), from += joint.mean_rows;
    joint.impulse_step = *from++, joint.mean_time = *from++;
    return from;
}

}  // namespace

bool StepUndo::save_idleness(Arena& arena)
{
    if (!world_.watches_bodies) return true;
    // The program may make more bodies while it is asked for memory.
    const int places = world_.bodies.places();
    const auto idleness = arena.take<Idleness>(world_.bodies.active_count());
    if (arena.failed()) return false;
    std::size_t count = 0;
    world_.bodies.for_each_active_before(places, [&](Body& b) {
        if (b.auto_disable && !b.disabled) take_idleness(b, idleness[count++]);
    });
    idleness_ = idleness.first(count);
    return true;
}

bool StepUndo::wake(std::span<Body* const> sleepers, Arena& arena)
{
    if (!save_sleepers(sleepers, arena)) return false;
    for (Body* body : sleepers) epode::wake(*body);
    return true;
}

bool StepUndo::save_sleepers(std::span<Body* const> sleepers, Arena& arena)
{
    const auto idleness = arena.take<Idleness>(int(sleepers.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < sleepers.size(); ++i) take_idleness(*sleepers[i], idleness[i]);
    woken_[wakings_++] = idleness;
    return true;
}

void StepUndo::take_idleness(Body& b, Idleness& to)
{
    to.body = &b;
    copy(to.lvel, b.lvel), copy(to.avel, b.avel);
    to.spin_excess = b.spin_excess;
    to.short_window = b.short_window, to.long_window = b.long_window;
    to.settling_time = b.settling_time;
    to.time_left = b.idle_time_left, to.steps_left = b.idle_steps_left;
    to.next_sample = b.sample_next, to.samples_ready = b.samples_ready, to.slept = b.disabled;
}

bool StepUndo::save_islands(std::span<const Island> islands, Arena& arena)
{
    if (islands.empty()) return true;
    const std::span<Body* const> bodies = joined(islands.front().bodies, islands.back().bodies);
    saved_ = arena.take<Saved>(int(bodies.size()));
    marks_ = arena.take_zeroed<Mark>(int(bodies.size()));
    if (arena.failed() || !save_impulses(islands, arena)) return false;
    bodies_ = bodies;  // now there is something to restore
    int slept = 0;
    for_each_prefetched<1>(bodies_, [&](std::size_t i, Body& body) {
        marks_[i].slept = body.disabled;
        slept += body.disabled;
    });
    return slept == 0 || wake_reached(slept, arena);
}

// ODE leaves their counters as they were, and its rule looks at velocities only. By our windows they would be still
// for some steps more, and fall asleep again in the air.
bool StepUndo::wake_reached(int count, Arena& arena)
{
    const auto sleepers = arena.take<Body*>(count);
    if (arena.failed()) return false;
    std::copy_if(bodies_.begin(), bodies_.end(), sleepers.begin(), [](const Body* b) { return b->disabled; });
    if (world_.wakes_sleepers()) return wake(sleepers, arena);
    if (!world_.acts_as_ode() && !save_sleepers(sleepers, arena)) return false;
    for (Body* body : sleepers) {
        body->disabled = false;
        if (!world_.acts_as_ode()) forget_stillness(*body);
    }
    return true;
}

bool StepUndo::save_fluids(Arena& arena)
{
    before_fluids_ = arena.take<BeforeFluids>(int(bodies_.size()));
    if (arena.failed()) return false;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        before_fluids_[i] = {load(bodies_[i]->facc), load(bodies_[i]->tacc), bodies_[i]->fluid};
    return true;
}

// After restore_body(), which knows the accumulators with the fluids' forces.
void StepUndo::restore_fluids() const
{
    if (!fluids_act_) return;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const BeforeFluids& before = before_fluids_[i];
        store(bodies_[i]->facc, before.force), store(bodies_[i]->tacc, before.torque);
        bodies_[i]->fluid = before.fluid;
    }
}

void StepUndo::save(std::size_t i)
{
    const Body& body = *bodies_[i];
    saved_[i] = {body.position(),         body.orientation(),
                 body.rotation(),         body.velocity(),
                 body.angular_velocity(), load(body.facc),
                 load(body.tacc),         world_.exact_rotation ? body.spin_excess : Vec3{}};
    marks_[i].saved = true, marks_[i].had_manifolds = body.had_manifolds;
}

// Most joints are contacts, which remember nothing: islands know whether another does.
bool StepUndo::save_impulses(std::span<const Island> islands, Arena& arena)
{
    int joints = 0, rows = 0;
    for (const Island& island : islands)
        if (island.impulses) joints += int(island.joints.size());
    const auto remembering = arena.take<Remembering>(joints);
    if (arena.failed()) return false;
    std::size_t count = 0;
    for (const Island& island : islands) {
        if (!island.impulses) continue;
        for_each_prefetched<1>(std::span<Joint* const>(island.joints), [&](std::size_t, Joint& joint) {
            if (joint.impulse_rows == 0) return;
            remembering[count++] = {&joint, joint.impulse_rows, lasting(joint).mean_rows};
            rows += numbers_of(lasting(joint));
        });
    }
    impulses_ = arena.take<Real>(rows);
    if (arena.failed()) return false;
    joints_ = joined(islands.front().joints, islands.back().joints);  // now there is something to restore
    remembering_ = remembering.first(count);
    Real* to = impulses_.data();
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < remembering_.size(); ++i) {
        if (i + kAhead < remembering_.size()) prefetch<1>(impulses(*remembering_[i + kAhead].joint));
        to = take_memory(lasting(*remembering_[i].joint), to);
    }
    return true;
}

void StepUndo::restore() const
{
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        bodies_[i]->disabled = marks_[i].slept;
        if (marks_[i].saved) restore_body(i);
    }
    restore_fluids();
    restore_impulses();
    restore_idleness(idleness_);
    for (int i = wakings_; i-- > 0;) restore_idleness(woken_[i]);
}

void StepUndo::restore_idleness(std::span<const Idleness> all)
{
    for (const Idleness& from : all) {
        Body& b = *from.body;
        copy(b.lvel, from.lvel), copy(b.avel, from.avel);
        b.spin_excess = from.spin_excess;
        b.short_window = from.short_window, b.long_window = from.long_window;
        b.settling_time = from.settling_time;
        b.idle_time_left = from.time_left, b.idle_steps_left = from.steps_left;
        b.sample_next = from.next_sample, b.samples_ready = from.samples_ready;
        b.disabled = from.slept;
    }
}

void StepUndo::restore_body(std::size_t i) const
{
    Body& body = *bodies_[i];
    body.had_manifolds = marks_[i].had_manifolds;
    const Saved& saved = saved_[i];
    restore_pose(body, saved);
    store(body.lvel, saved.velocity), store(body.avel, saved.angular_velocity);
    store(body.facc, saved.force), store(body.tacc, saved.torque);
}

void StepUndo::restore_bodies(std::span<Body* const> piece) const
{
    const std::size_t first = first_of(piece);
    for (std::size_t i = 0; i < piece.size(); ++i) restore_body(first + i);
}

void StepUndo::restore_poses(std::span<Body* const> piece) const
{
    const Saved* saved = saved_.data() + first_of(piece);
    for (Body* body : piece) {
        restore_pose(*body, *saved);
        ++saved;
    }
}

void StepUndo::restore_pose(Body& body, const Saved& saved)
{
    store(body.pos, saved.position);
    store_quat(body.q, saved.orientation);
    store_mat(body.R, saved.rotation);
    body.spin_excess = saved.spin_excess;
}

void StepUndo::restore_impulses() const
{
    for (Joint* joint : joints_) joint->impulse_rows = 0;
    const Real* from = impulses_.data();
    for (const Remembering& r : remembering_) {
        r.joint->impulse_rows = r.rows;
        lasting(*r.joint).mean_rows = r.mean_rows;
        from = restore_memory(from, lasting(*r.joint));
    }
}

}  // namespace epode
