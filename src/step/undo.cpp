// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Islands are pieces of two arrays that hold all bodies and all joints, which are gone through as a whole:
// a thousand islands of one body cost no more than one of a thousand.
#include "step/undo.h"

#include <algorithm>
#include <cstring>

#include "base/ahead.h"

namespace epode {
namespace {

constexpr int kLinesOfState = 6;  // of a body, with its tag and its accumulators

// f(member of the body, member of the copy) for each array that both have.
template <typename B, typename S, typename Visit>
void for_members(B& body, S& saved, Visit&& f)
{
    f(body.pos, saved.pos), f(body.q, saved.q), f(body.R, saved.R);
    f(body.lvel, saved.lvel), f(body.avel, saved.avel);
    f(body.facc, saved.facc), f(body.tacc, saved.tacc);
}

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

}  // namespace

bool StepUndo::save_idleness(Arena& arena)
{
    int count = 0;
    for (const Body* b = world_.bodies; b; b = b->next) count += b->auto_disable;
    idleness_ = arena.take<Idleness>(count);
    if (arena.failed()) return false;
    if (!count) return true;
    Idleness* to = idleness_.data();
    for (const Body* b = world_.bodies; b; b = b->next) {
        if (!b->auto_disable) continue;
        copy(to->lvel, b->lvel), copy(to->avel, b->avel);
        to->spin_excess = b->spin_excess;
        to->time_left = b->idle_time_left, to->steps_left = b->idle_steps_left;
        to->next_sample = b->sample_next, to->samples_ready = b->samples_ready;
        to->disabled = b->disabled;
        ++to;
    }
    return true;
}

bool StepUndo::save_islands(std::span<const Island> islands, Arena& arena)
{
    if (islands.empty()) return true;
    const std::span<Body* const> bodies = joined(islands.front().bodies, islands.back().bodies);
    saved_ = arena.take<Saved>(int(bodies.size()));
    joints_ = joined(islands.front().joints, islands.back().joints);
    if (arena.failed() || !save_impulses(arena)) return false;
    bodies_ = bodies;  // now there is something to restore
    for_each_fetched<kLinesOfState>(bodies_, [&](std::size_t i, Body& body) {
        Saved& saved = saved_[i];
        for_members(body, saved, [](auto& from, auto& to) { copy(to, from); });
        saved.spin_excess = body.spin_excess;
        saved.disabled = body.disabled;
        body.disabled = false;
    });
    return true;
}

bool StepUndo::save_impulses(Arena& arena)
{
    int count = 0;
    for (const Joint* joint : joints_) count += joint->impulse_rows;
    const auto rows = arena.take<int>(int(joints_.size()));
    impulses_ = arena.take<Real>(count);
    if (arena.failed()) return false;
    Real* to = impulses_.data();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        rows[i] = joints_[i]->impulse_rows;
        to = std::copy_n(joints_[i]->impulse, rows[i], to);
    }
    impulse_rows_ = rows;
    return true;
}

void StepUndo::restore() const
{
    restore_bodies();
    restore_impulses();
    if (idleness_.empty()) return;
    const Idleness* from = idleness_.data();
    for (Body* b = world_.bodies; b; b = b->next) {
        if (!b->auto_disable) continue;
        copy(b->lvel, from->lvel), copy(b->avel, from->avel);
        b->spin_excess = from->spin_excess;
        b->idle_time_left = from->time_left, b->idle_steps_left = from->steps_left;
        b->sample_next = from->next_sample, b->samples_ready = from->samples_ready;
        b->disabled = from->disabled;
        ++from;
    }
}

void StepUndo::restore_bodies() const
{
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = *bodies_[i];
        const Saved& saved = saved_[i];
        for_members(body, saved, [](auto& to, const auto& from) { copy(to, from); });
        body.spin_excess = saved.spin_excess;
        body.disabled = saved.disabled;
    }
}

void StepUndo::restore_impulses() const
{
    const Real* from = impulses_.data();
    for (std::size_t i = 0; i < impulse_rows_.size(); ++i) {
        Joint& joint = *joints_[i];
        joint.impulse_rows = impulse_rows_[i];
        std::copy_n(from, joint.impulse_rows, joint.impulse);
        from += joint.impulse_rows;
    }
}

}  // namespace epode
