// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/history.h"

#include <atomic>
#include <new>

#include "base/objects/structure_edition.h"
#include "collide/geom_leaves.h"
#include "collide/space.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "state/world_archive.h"
#include "step/common/link.h"

namespace epode {
namespace {

std::atomic<int> g_worlds{0};

// An object with what it owns, in memory that may be refused.
Topology* make_topology()
{
    void* memory = allocate(sizeof(Topology));
    return memory ? new (memory) Topology : nullptr;
}

void destroy_topology(Topology* topology)
{
    if (!topology) return;
    topology->~Topology();
    release(topology, sizeof *topology);
}

void set_recorder(const Topology& topology, void* from, void* to)
{
    for (const Topology::GeomRecord& r : topology.geoms)
        if ((r.geom.lives() || r.geom.is_parked()) && (!from || r.geom.object->recorder == from))
            r.geom.object->recorder = to;
}

bool may_come_back(const Geom& geom)
{
    return !is_space(geom) && stands_alone(geom) && !geom.type->farewell && !geom.holders;
}

}  // namespace

int History::worlds() { return g_worlds.load(std::memory_order_relaxed); }

bool History::set_frames(int frames)
{
    clear();
    if (frames == 0) return true;
    if (!ring_.resize(frames + 1)) return false;
    frames_ = frames;
    g_worlds.fetch_add(1, std::memory_order_relaxed);
    if (capture()) return true;
    clear();
    return false;
}

std::size_t History::bytes() const
{
    std::size_t sum = sizeof(Frame) * std::size_t(ring_.size()) + present_.capacity;
    const Topology* before = nullptr;
    for (const Frame& f : ring_) {
        sum += f.state.capacity;
        if (f.topology && f.topology != before) sum += f.topology->bytes();
        before = f.topology;
    }
    return sum;
}

void History::let_go(Frame& frame)
{
    Topology* const topology = frame.topology;
    frame.topology = nullptr;
    if (!topology || --topology->users > 0) return;
    set_recorder(*topology, this, nullptr);
    const Topology* before = nullptr;
    for (int i = 0; i < count_; ++i)
        if (const Topology* kept = this->frame(newest_ - std::uint64_t(i)).topology; kept != before)
            set_recorder(*kept, nullptr, this), before = kept;
    destroy_topology(spare_);
    spare_ = topology;
}

void History::forget()
{
    while (count_ > 0) let_go(frame(newest_ + 1 - std::uint64_t(count_--)));
    parking_.destroy_before(~std::uint64_t(0));
}

void History::clear()
{
    forget();
    for (Frame& f : ring_) f.state.release();
    ring_.reset();
    present_.release();
    destroy_topology(spare_);
    spare_ = nullptr;
    if (frames_ > 0) g_worlds.fetch_sub(1, std::memory_order_relaxed);
    frames_ = 0;
}

void History::step_made()
{
    if (frames_ == 0 || capture()) return;
    forget();
    refuse_for("dWorldSetHistory", "out of memory: the history has lost its frames");
}

bool History::capture()
{
    const bool full = count_ == ring_.size();
    Frame& next = frame(newest_ + 1);
    if (full) {
        --count_;
        let_go(next);
        parking_.destroy_before(newest_ + 1 - std::uint64_t(count_));
    }
    const std::size_t expected = count_ > 0 ? frame(newest_).state.size : 0;
    next.state.size = 0;
    if (!state_.prepare(WorldState::Joints::kLasting) || !next.state.reserve(expected) ||
        !state_.append(next.state, Seal::kUnsealed))
        return false;
    if (!take_topology(next)) return false;
    ++newest_, ++count_;
    return true;
}

bool History::take_topology(Frame& to)
{
    Topology* const last = count_ > 0 ? frame(newest_).topology : nullptr;
    if (last && last->edition == structure_edition()) {
        to.topology = last;
        ++last->users;
        return true;
    }
    Topology* fresh = spare_ ? spare_ : make_topology();
    spare_ = nullptr;
    if (!fresh) return false;
    if (!fresh->record(world_, false)) return spare_ = fresh, false;
    set_recorder(*fresh, nullptr, this);
    fresh->users = 1;
    to.topology = fresh;
    return true;
}

// Geoms that leave their space and enter it again have lost their contacts. False: out of memory.
bool History::remember_present(const Topology& target)
{
    present_.size = 0;
    return target.edition == structure_edition() ||
           (state_.prepare() && state_.append(present_, Seal::kUnsealed));
}

const char* History::roll_back(int frames)
{
    const std::uint64_t number = newest_ - std::uint64_t(frames);
    Frame& target = frame(number);
    Topology now;
    if (!now.record(world_, true) || !now.record_spaces_of(*target.topology)) return kOutOfMemory;
    Arrangement arrangement(world_, parking_);
    if (const char* obstacle = arrangement.prepare(now, *target.topology, text_, sizeof text_))
        return obstacle;
    if (!remember_present(*target.topology)) return kOutOfMemory;
    arrangement.apply(now, *target.topology, 0);
    const char* wrong = kOutOfMemory;
    if (state_.prepare(WorldState::Joints::kLasting))
        wrong = state_.set(target.state.data, target.state.size, Seal::kUnsealed);
    if (wrong) {
        arrangement.apply(*target.topology, now, newest_);
        if (present_.size > 0 && state_.prepare())
            (void)state_.set(present_.data, present_.size, Seal::kUnsealed);
        for (const Topology::GeomRecord& r : now.geoms)  // nothing has happened to them
            r.geom.object->watched = r.watched, r.geom.object->disturbed = r.disturbed;
        return wrong;
    }
    while (newest_ > number) {
        Frame& later = frame(newest_);
        --newest_, --count_;
        let_go(later);
    }
    parking_.enter_groups();
    target.topology->edition = structure_edition();
    parking_.forget_after(number);
    parking_.destroy_before(1);  // what has been created since
    return nullptr;
}

bool History::keep(Body& body)
{
    if (count_ == 0 || !parking_.reserve(1)) return false;
    release_geoms(body);
    while (body.joints) detach(*body.joints->joint);
    forget_forces(body);
    world_.bodies.leave(body);
    note_structure_changed();
    parking_.put(body, newest_);
    return true;
}

bool History::keep(Joint& joint, dJointGroupID group)
{
    if (count_ == 0 || is_contact(joint) || !parking_.reserve(1)) return false;
    detach(joint);
    unlink_from_world(joint);
    joint.grouped = false;
    parking_.put(joint, group, newest_);
    return true;
}

bool History::keep(Geom& geom)
{
    if (count_ == 0 || !may_come_back(geom) || !parking_.reserve(1)) return false;
    if (geom.space) remove_geom(*geom.space, geom);
    unlink_body(geom);
    drop_leaves(geom);
    note_structure_changed();
    parking_.put(geom, newest_);
    return true;
}

}  // namespace epode
