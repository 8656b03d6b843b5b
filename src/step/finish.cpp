// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/finish.h"

#include <algorithm>

#include "base/float_environment.h"
#include "collide/space.h"
#include "dynamics/integrate.h"
#include "step/common/link.h"
#include "tasks/prefetched.h"

namespace epode {
namespace {

constexpr int kAhead = 10;
constexpr std::size_t kMany = 8;  // a part of 1 / kMany

// What one() reads and writes of a body.
void prefetch_body(const Body& body) { prefetch<1>(&body), prefetch<3>(body.lvel); }

void call_moved_callback(Body& body)
{
    const CallerFloatEnvironment program;
    body.moved(to_handle(&body));
}

void empty(Body& body, Runaways& runaways)
{
    runaways.check(body);
    damp(body);
    store(body.facc, {});
    store(body.tacc, {});
    body.had_manifolds = body.manifolds != nullptr;
    body.manifolds = nullptr;
}

}  // namespace

void finish_silently(Unfinished& left, Runaways& runaways)
{
    for (std::size_t i = 0; i < left.bodies.size(); ++i)
        if (left.has(i)) empty(*left.bodies[i], runaways);
    left = {};
}

bool Finish::begin(std::span<Body* const> bodies, bool early, Arena& arena)
{
    bodies_ = bodies;
    early_ = early;
    any_left_ = !early;
    done_ = arena.take_zeroed<bool>(int(bodies.size()));
    return !arena.failed();
}

void Finish::at_once(std::span<Body* const> piece, const Tasks& tasks)
{
    if (!early_) return;
    const auto first = std::size_t(piece.data() - bodies_.data());
    tasks.in_ranges(int(piece.size()), kObjectRange, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            if (i + 2 * kAhead < end) prefetch_body(*piece[std::size_t(i + 2 * kAhead)]);
            if (i + kAhead < end) prefetch_geoms(*piece[std::size_t(i + kAhead)]);
            Body& body = *piece[std::size_t(i)];
            if (body.has_moved_callback || !mark_geoms(body)) {
                any_left_.store(true, std::memory_order_relaxed);
                continue;
            }
            empty(body, runaways_);
            done_[first + std::size_t(i)] = true;
        }
    });
}

// Callbacks come last: one that does not return leaves nothing to be done but the bodies of those after it.
void Finish::rest(Unfinished& left)
{
    report_marked();
    if (!any_left_) return;
    left = {bodies_, done_};
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (left.has(i + 2 * kAhead)) prefetch_body(*bodies_[i + 2 * kAhead]);
        if (left.has(i + kAhead)) prefetch_geoms(*bodies_[i + kAhead]);
        if (!left.has(i)) continue;
        Body& body = *bodies_[i];
        if (moves_geoms(body)) body_stepped(body);
        done_[i] = !body.has_moved_callback;
        if (done_[i]) empty(body, runaways_);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (!left.has(i)) continue;
        if (bodies_[i]->has_moved_callback) call_moved_callback(*bodies_[i]);
        empty(*bodies_[i], runaways_);
        done_[i] = true;
    }
    left = {};
}

// False: they must wait for rest().
bool Finish::mark_geoms(Body& body) const
{
    if (contact_space_) return mark_members(body, *contact_space_);
    if (alone_) body_stepped(body);
    return alone_;
}

bool Finish::moves_geoms(const Body& body) const
{
    return !continuous_.marked() || continuous_.stopped(body);
}

// Reports the marked members to the space: as a list if they are few, else the space checks all.
void Finish::report_marked() const
{
    if (!contact_space_ || !early_ || bodies_.empty()) return;
    const bool few = kMany * bodies_.size() <= std::size_t(contact_space_->count);
    few&& list_marked() ? note_geoms_listed(*contact_space_) : note_geoms_marked(*contact_space_);
}

bool Finish::list_marked() const
{
    return std::all_of(bodies_.begin(), bodies_.end(),
                       [&](const Body* body) { return list_members(*body, *contact_space_); });
}

}  // namespace epode
