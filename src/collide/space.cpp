// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Membership and cleaning.
#include "collide/space.h"

#include <algorithm>

#include "base/prefetch.h"

namespace epode {
namespace {

// Closes the gaps; false when memory is exhausted (nothing has changed then).
bool compact(Space& space)
{
    Array<int> new_slot;
    if (!new_slot.reserve(space.members.size())) return false;
    int kept = 0;
    for (Geom* geom : space.members) (void)new_slot.push(geom ? kept++ : -1);
    space.broadphase.renumber(new_slot.span(), kept);
    int queued = 0;
    for (int slot : space.queue)
        if (new_slot[slot] >= 0) space.queue[queued++] = new_slot[slot];
    space.queue.truncate(queued);
    for (int i = 0; i < space.members.size(); ++i)
        if (Geom* geom = space.members[i]) {
            geom->slot = new_slot[i];
            space.members[geom->slot] = geom;
        }
    space.members.truncate(kept);
    return true;
}

bool has_gaps(const Space& space) { return space.count != space.members.size(); }

// One more slot in every list that is indexed by slots or holds them.
bool make_room(Space& space)
{
    const int wanted = space.members.size() + 1;
    if (space.broadphase.slots() >= wanted) return true;
    if (space.count < space.members.size() / 2) return compact(space);
    const int room = std::max(8, wanted + wanted / 2);
    return space.members.reserve(room) && space.queue.reserve(room) && space.broadphase.reserve(room);
}

// Spaces in line downwards, the space included.
int height(const Space& space)
{
    int most = 0;
    for (const Geom* m : space.members)
        if (m && is_space(*m)) most = std::max(most, height(static_cast<const Space&>(*m)));
    return most + 1;
}

bool zero_sized(const Geom& geom) { return geom.type->zero_sized && geom.type->zero_sized(geom); }

void note_disturbed(Space& space, const Geom& geom)
{
    if (geom.at_rest) space.disturbances.note(geom);
}

// Puts into the queue all who are marked so.
void list_queued(Space& space)
{
    if (!space.unlisted) return;
    space.unlisted = false;
    space.queue.clear();
    for (const Geom* geom : space.members)
        if (geom && geom->queued) (void)space.queue.push(geom->slot);
}

// Those in the queue that are chosen; the others leave it, too, but stay marked.
template <typename Chosen>
void clean_queued(Space& space, Chosen&& chosen)
{
    constexpr int kAhead = 8;
    const int due = space.queue.size();
    const auto due_in = [&](int i) { return i < due ? space.members[space.queue[i]] : nullptr; };
    for (int i = 0; i < due; ++i) {
        if (const Geom* geom = due_in(i + 2 * kAhead))
            prefetch_shape(*geom), space.broadphase.prefetch_box(space.queue[i + 2 * kAhead]);
        if (const Geom* geom = due_in(i + kAhead))
            prefetch<3>(geom->position), space.broadphase.prefetch_fat_box(geom->slot);
        const int slot = space.queue[i];
        Geom* geom = space.members[slot];
        if (!geom || !geom->queued || !chosen(*geom)) continue;
        geom->queued = false;
        if (is_space(*geom)) clean(static_cast<Space&>(*geom));
        const Aabb& box = box_of(*geom);
        space.broadphase.update(slot, box, !zero_sized(*geom));
    }
    // Members that a user's box function has moved wait for the next time.
    std::copy(space.queue.begin() + due, space.queue.end(), space.queue.begin());
    space.queue.truncate(space.queue.size() - due);
}

}  // namespace

Space* space_from(dSpaceID id)
{
    Geom* geom = from_handle<Geom>(reinterpret_cast<dGeomID>(id));
    return !kChecked || (geom && is_space(*geom)) ? static_cast<Space*>(geom) : nullptr;
}

dSpaceID id_of(const Space* space) { return reinterpret_cast<dSpaceID>(to_handle<Geom>(space)); }

bool add_member(Space& space, Geom& geom)
{
    if (!make_room(space)) return false;
    geom.space = &space;
    geom.slot = space.members.size();
    geom.queued = false;
    (void)space.members.push(&geom);
    ++space.count;
    space.helped += !stands_alone(geom);
    mark_moved(geom);
    return true;
}

void remove_member(Space& space, Geom& geom)
{
    space.members[geom.slot] = nullptr;
    space.broadphase.remove(geom.slot);
    note_disturbed(space, geom);
    geom.at_rest = false;
    ++space.edition;
    geom.space = nullptr;
    geom.slot = -1;
    geom.queued = false;
    space.helped -= !stands_alone(geom);
    if (--space.count == 0) {
        space.members.clear();
        space.queue.clear();
        space.broadphase.clear();
    }
    mark_moved(space);
}

void empty_space(Space& space)
{
    for (int slot = space.members.size(); slot-- > 0;) {
        // The last member clears the list; a user's destructor function may take others with it.
        Geom* geom = slot < space.members.size() ? space.members[slot] : nullptr;
        if (!geom) continue;
        if (space.cleanup && !geom->dying)
            destroy_geom(*geom);
        else
            remove_member(space, *geom);
    }
}

Geom* member(Space& space, int index)
{
    if (has_gaps(space) && space.locks == 0) (void)compact(space);
    if (!has_gaps(space)) return space.members[space.count - 1 - index];
    for (int slot = space.members.size(); slot-- > 0;)
        if (space.members[slot] && index-- == 0) return space.members[slot];
    return nullptr;
}

bool is_inside(const Geom& geom, const Space& space)
{
    for (const Geom* g = &geom; g; g = g->space)
        if (g == &space) return true;
    return false;
}

bool nesting_fits(const Space& space, const Space& inner)
{
    int above = 0;
    for (const Geom* g = &space; g; g = g->space) ++above;
    return above + height(inner) <= kMostNested;
}

void enqueue(Space& space, Geom& geom)
{
    // Room was made when the member joined; only a move during the cleaning itself may need more.
    geom.queued = space.queue.push(geom.slot);
    note_disturbed(space, geom);
    ++space.edition;
}

void members_marked(Space& space)
{
    space.unlisted = true;
    members_listed(space);
}

void members_listed(Space& space)
{
    ++space.edition;
    mark_moved(space);
}

void note_rules_changed(Geom& geom)
{
    if (geom.space) note_disturbed(*geom.space, geom);
    for (Space* space = geom.space; space; space = space->space) ++space->edition;
}

void clean(Space& space)
{
    if (space.locks > 0 || is_clean(space)) return;
    SpaceLock lock(space);
    list_queued(space);
    clean_queued(space, [](const Geom&) { return true; });
}

void clean(Space& space, const WayFinder& finder, const Tasks& tasks)
{
    const bool moves = space.locks == 0 && !is_clean(space);
    SpaceLock lock(space);
    if (moves && space.helped > 0) {
        list_queued(space);
        clean_queued(space, [](const Geom& geom) { return !stands_alone(geom); });
    } else if (moves) {
        space.queue.clear();
        space.unlisted = false;
    }
    Broadphase& boxes = space.broadphase;
    const int count = space.members.size();
    Geom* const* members = space.members.data();
    boxes.note_all(tasks, count, [&](int slot, Broadphase::Notes& notes) {
        constexpr int kAhead = 6;
        const auto member = [&](int i) { return i < count ? members[i] : nullptr; };
        if (const Geom* soon = member(slot + 2 * kAhead)) prefetch_shape(*soon), prefetch<1>(&soon->body);
        if (const Geom* next = member(slot + kAhead))
            prefetch<5>(next->body.id), boxes.prefetch_fat_box(slot + kAhead);
        Geom* geom = members[slot];
        if (!geom) return;
        if (moves && geom->queued && stands_alone(*geom)) {
            geom->queued = false;
            notes.update(slot, box_of(*geom), !zero_sized(*geom));
        }
        if (geom->body.id && boxes.present(slot))
            notes.expect(slot, finder.way(finder.data, *geom, boxes.box(slot)));
    });
}

Aabb space_aabb(Geom& geom)
{
    Space& space = static_cast<Space&>(geom);
    clean(space);
    Aabb all{};
    bool first = true;
    for (Geom* m : space.members) {
        if (!m) continue;
        all = first ? box_of(*m) : merge(all, box_of(*m));
        first = false;
    }
    return all;
}

}  // namespace epode
