// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The search for what is shared reads every body and its geoms once, several worlds at a time; sharing is
// then an equivalence over sorted pairs (what, who). Addresses are compared to find equal ones, and decide
// nothing else: a piece is named by its first world.
#include "step/batch.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "collide/collide.h"
#include "collide/space.h"
#include "dynamics/joint_drives.h"
#include "query/candidates.h"
#include "step/common/link.h"
#include "step/fluids.h"
#include "step/step.h"
#include "step/steppers/stepper.h"
#include "tasks/tasks.h"

namespace epode {
namespace {

const ContactWorld* world_contacts(const World& world)
{
    const bool manages = world.step_state && world.step_state->world_contacts.live_space();
    return manages ? &world.step_state->world_contacts : nullptr;
}

bool calls_program_inside(Space& space)
{
    return !each_candidate(space, [](Geom& g) { return !may_call_program(g); });
}

// visit(space) for the outermost spaces that the bodies' geoms are in; repeats itself.
template <typename Visit>
void for_spaces(World& world, Visit&& visit)
{
    Space* last = nullptr;
    for (Body& body : world.bodies)
        for_each_geom(body, [&](Geom& geom) {
            Space* const space = outermost_space(geom);
            if (space && space != last) visit(space);
            last = space;
        });
}

// visit(what) for all that a step of the world changes and another world may hold too; repeats itself.
template <typename Visit>
void for_shares(World& world, Visit&& visit)
{
    if (world.memory && world.memory->shared()) visit(world.memory);
    if (const ContactWorld* contacts = world_contacts(world)) {
        Space* const space = contacts->live_space();
        Space* const outermost = outermost_space(*space);
        visit(outermost ? outermost : space);
    }
    for_spaces(world, visit);
}

// Of the body itself, and of geoms in transforms: those are marked wherever the transform is.
bool calls_program(const Body& body)
{
    bool calls = body.has_moved_callback;
    for_each_geom(body, [&](Geom& geom) { calls = calls || geom.holders; });
    return calls;
}

bool calls_program(const ContactWorld& contacts)
{
    return contacts.filter || (contacts.function && !contacts.function_on_threads) ||
           calls_program_inside(*contacts.live_space());
}

// Worlds that draw from the process's generator take turns as well, in the order of the array.
bool calls_program(World& world)
{
    if (world.threading || world.acts_as_ode() || fluids_call_program(world)) return true;
    for (Body& body : world.bodies)
        if (calls_program(body)) return true;
    const ContactWorld* contacts = world_contacts(world);
    if (!contacts && !any_continuous()) return false;
    if (any_overridden() || (contacts && calls_program(*contacts))) return true;
    if (!any_continuous()) return false;
    bool calls = false;
    for_spaces(world, [&](Space* space) { calls = calls || calls_program_inside(*space); });
    return calls;
}

// ---- a world comes out of main memory, unless only few are stepped: what its step reads is fetched while others
// are stepped, into the second level of the cache, where it does not displace what they work with. Another worker
// may step it at the same time, so only what no step changes is read ----

void fetch(const void* first, std::size_t bytes)
{
    const auto* at = static_cast<const char*>(first);
    for (std::size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(at + i, 0, 2);
}

constexpr std::size_t kJointBytes = 768;  // of a joint with two axes; more than most have

// Objects, whose addresses the world has.
void fetch_objects(const World& world)
{
    for (const Body& body : world.bodies) fetch(&body, sizeof body);
    for (const Joint& joint : world.joints) fetch(&joint, kJointBytes);
    if (!world.step_state) return;
    const Space* const space = world.step_state->world_contacts.live_space();
    if (!space) return;
    for (const Geom* geom : space->geoms)
        if (geom) fetch(geom, sizeof *geom + sizeof(GeomOffset));
}

// What these objects lead to.
void fetch_parts(const World& world)
{
    for (const Joint& joint : world.joints)
        if (!is_contact(joint))
            if (const JointDrives* drives = static_cast<const LastingJoint&>(joint).drives)
                fetch(drives, sizeof(AxisDrive));
    if (!world.step_state) return;
    const Space* const space = world.step_state->world_contacts.live_space();
    if (!space) return;
    for (const Geom* geom : space->geoms)
        if (geom && geom->offset) fetch(geom->offset, sizeof(GeomOffset));
}

// Does it make no difference to the program where its steps work? Not if it shares memory or supplies it.
bool borrows_memory(const World& world)
{
    if (!world.memory) return true;
    const ArenaSupply standard, &supply = world.memory->supply();
    return !world.memory->shared() && !supply.alloc && !supply.free && supply.factor == standard.factor &&
           supply.minimum == standard.minimum;
}

}  // namespace

bool WorldBatch::add(World& world)
{
    if (!entries_.push({&world, {}, 0, false, entries_.size()})) return false;
    mark_busy(world, Busy::kStep);
    return true;
}

void WorldBatch::unmark(void*, const void* entries, std::size_t count)
{
    for (const Entry& entry : std::span(static_cast<const Entry*>(entries), count))
        mark_busy(*entry.world, Busy::kNo);
}

WorldBatch::~WorldBatch() { unmark(nullptr, entries_.data(), std::size_t(entries_.size())); }

void WorldBatch::survey(Entry& entry)
{
    (void)step_state(*entry.world);  // fetch_objects() may look for it while the world is stepped
    entry.calls_program = epode::calls_program(*entry.world);
    for_shares(*entry.world, [&](const void* what) {
        const int known = std::min(entry.share_count, kInline);
        for (int i = 0; i < known; ++i)
            if (entry.shares[i] == what) return;
        if (entry.share_count < kInline) entry.shares[entry.share_count] = what;
        ++entry.share_count;
    });
}

bool WorldBatch::prepare(int threads)
{
    threads_ = threads > 0 ? threads : processor_count();
    Tasks(threads_).for_each(entries_.size(), [this](int i, int) { survey(entries_.data()[i]); });
    if (!collect_shares() || !order_.reserve(entries_.size()) || !pieces_.reserve(entries_.size()))
        return false;
    join_sharers();
    make_pieces();
    return lend_memory();
}

// From the first worlds of the array, so that later calls find it as large as it has become. False: out of memory.
bool WorldBatch::lend_memory()
{
    threads_ = std::max(1, std::min(threads_, pieces_.size()));
    if (!lent_.reserve(threads_)) return false;
    for (int i = 0; i < entries_.size() && lent_.size() < threads_; ++i) {
        World& world = *entries_[i].world;
        if (!borrows_memory(world)) continue;
        StepMemory* const memory = working_memory(world);
        if (!memory) return false;
        (void)lent_.push(memory);
    }
    if (lent_.size() < threads_) lent_.clear();
    return true;
}

StepMemory* WorldBatch::memory_for(const World& world, int worker) const
{
    return !lent_.empty() && borrows_memory(world) ? lent_.data()[worker] : nullptr;
}

bool WorldBatch::collect_shares()
{
    int capacity = 0;
    for (const Entry& entry : entries_) capacity += entry.share_count;
    if (!shares_.reserve(capacity)) return false;
    bool complete = true;
    for (int i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        const auto note = [&](const void* what) { complete = shares_.push({what, i}) && complete; };
        if (entry.share_count > kInline)
            for_shares(*entry.world, note);
        else
            std::for_each_n(entry.shares, entry.share_count, note);
    }
    std::sort(shares_.begin(), shares_.end(), [](const Share& a, const Share& b) {
        return a.what != b.what ? std::less<>()(a.what, b.what) : a.entry < b.entry;
    });
    return complete;
}

int WorldBatch::find(int entry)
{
    while (entries_[entry].piece != entry) {
        entries_[entry].piece = entries_[entries_[entry].piece].piece;
        entry = entries_[entry].piece;
    }
    return entry;
}

void WorldBatch::join_sharers()
{
    for (int i = 1; i < shares_.size(); ++i) {
        if (shares_[i].what != shares_[i - 1].what) continue;
        const int a = find(shares_[i].entry), b = find(shares_[i - 1].entry);
        entries_[std::max(a, b)].piece = std::min(a, b);
    }
    for (int i = 0; i < entries_.size(); ++i) {
        Entry &entry = entries_[i], &first = entries_[find(i)];
        entry.piece = first.piece;
        first.calls_program = first.calls_program || entry.calls_program;
    }
}

// Entries of a piece follow each other; places were reserved.
void WorldBatch::make_pieces()
{
    const auto on_caller = [&](int i) { return entries_[entries_[i].piece].calls_program; };
    for (int i = 0; i < entries_.size(); ++i) (void)order_.push(i);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) {
        if (on_caller(a) != on_caller(b)) return on_caller(b);
        if (on_caller(a) || entries_[a].piece == entries_[b].piece) return a < b;
        return entries_[a].piece < entries_[b].piece;
    });
    for (own_ = 0; own_ < order_.size() && !on_caller(order_[own_]); ++own_) {
        const Entry& entry = entries_[order_[own_]];
        if (own_ == 0 || entries_[order_[own_ - 1]].piece != entry.piece) (void)pieces_.push({own_, 0, 0});
        ++pieces_.back().count;
        pieces_.back().weight += entry.world->bodies.count() + entry.world->joints.count();
    }
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.first < b.first;
    });
}

// Of the worlds that will probably be stepped after the piece.
void WorldBatch::fetch_ahead(int piece) const
{
    const auto world_of = [&](int p) -> const World& {
        return *entries_.data()[order_.data()[pieces_.data()[p].first]].world;
    };
    const int last = pieces_.size() - 1;
    if (piece + threads_ <= last) fetch_parts(world_of(piece + threads_));
    if (piece + 2 * threads_ <= last) fetch_objects(world_of(piece + 2 * threads_));
    if (piece + 3 * threads_ <= last) fetch(&world_of(piece + 3 * threads_), sizeof(World));
}

int WorldBatch::make_steps(World& world, const Step& step, int steps, StepMemory* lent) const
{
    const int iterations = step.stepper.has_substeps ? step.substeps : world.quick_iterations;
    int done = 0;
    while (done < steps && step_world(world, step.stepper, step.h, iterations, lent)) ++done;
    return done;
}

int WorldBatch::run(const Step& step, int steps, int* made)
{
    std::atomic<int> whole{0};
    const auto run_one = [&](int place, StepMemory* lent) {
        const int entry = order_.data()[place];
        const int done = make_steps(*entries_.data()[entry].world, step, steps, lent);
        if (made) made[entry] = done;
        if (done == steps) whole.fetch_add(1, std::memory_order_relaxed);
    };
    Tasks(threads_).for_each(pieces_.size(), [&](int p, int worker) {
        const Piece& piece = pieces_.data()[p];
        fetch_ahead(p);
        for (int i = piece.first; i < piece.first + piece.count; ++i)
            run_one(i, memory_for(*entries_.data()[order_.data()[i]].world, worker));
    });
    // Functions of the program may free or share what a world has.
    const CallGuard guard(unmark, nullptr, entries_.data(), std::size_t(entries_.size()));
    for (int place = own_; place < order_.size(); ++place) run_one(place, nullptr);
    return whole.load();
}

}  // namespace epode
