// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Membership and cleaning.
#include "collide/space.h"

#include <algorithm>
#include <atomic>

#include "base/objects/structure_edition.h"
#include "base/prefetch.h"
#include "collide/transform.h"

namespace epode {
namespace {

std::atomic<std::uint64_t> g_disturbances{0};  // of the process, so far

// Closes the gaps; false when memory is exhausted (nothing has changed then).
bool compact(Space& space)
{
    Array<int> new_slot;
    if (!new_slot.reserve(space.geoms.size())) return false;
    int kept = 0;
    for (Geom* geom : space.geoms) (void)new_slot.push(geom ? kept++ : -1);
    space.broadphase.renumber(new_slot.span(), kept);
    int queued = 0;
    for (int slot : space.queue)
        if (new_slot[slot] >= 0) space.queue[queued++] = new_slot[slot];
    space.queue.truncate(queued);
    for (int i = 0; i < space.geoms.size(); ++i)
        if (Geom* geom = space.geoms[i]) {
            geom->slot = new_slot[i];
            space.geoms[geom->slot] = geom;
        }
    space.geoms.truncate(kept);
    note_structure_changed();
    return true;
}

bool has_gaps(const Space& space) { return space.count != space.geoms.size(); }

// One more slot in every list that is indexed by slots or holds them.
bool reserve_slots(Space& space)
{
    const int wanted = space.geoms.size() + 1;
    if (space.broadphase.slots() >= wanted) return true;
    if (space.count < space.geoms.size() / 2) return compact(space);
    const int capacity = std::max(8, wanted + wanted / 2);
    return space.geoms.reserve(capacity) && space.queue.reserve(capacity) &&
           space.broadphase.reserve(capacity);
}

// Spaces in line downwards, the space included.
int height(const Space& space)
{
    int highest = 0;
    for (const Geom* m : space.geoms)
        if (m && is_space(*m)) highest = std::max(highest, height(static_cast<const Space&>(*m)));
    return highest + 1;
}

bool zero_sized(const Geom& geom) { return geom.type->zero_sized && geom.type->zero_sized(geom); }

// Puts into the queue all who are marked so.
void list_queued(Space& space)
{
    if (!space.unlisted) return;
    space.unlisted = false;
    space.queue.clear();
    for (const Geom* geom : space.geoms)
        if (geom && geom->queued) (void)space.queue.push(geom->slot);
}

// Those in the queue that are chosen; the others leave it, too, but stay marked.
template <typename Chosen>
void clean_queued(Space& space, Chosen&& chosen)
{
    constexpr int kAhead = 8;
    const int due = space.queue.size();
    const auto due_in = [&](int i) { return i < due ? space.geoms[space.queue[i]] : nullptr; };
    for (int i = 0; i < due; ++i) {
        if (const Geom* geom = due_in(i + 2 * kAhead))
            prefetch_shape(*geom), space.broadphase.prefetch_box(space.queue[i + 2 * kAhead]);
        if (const Geom* geom = due_in(i + kAhead))
            prefetch<3>(geom->position), space.broadphase.prefetch_fat_box(geom->slot);
        const int slot = space.queue[i];
        Geom* geom = space.geoms[slot];
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

void DeepLock::count(Space& space, int by)
{
    space.locks += by;
    if (space.helped == 0) return;  // no spaces among them
    for (Geom* inner : space.geoms)
        if (inner && is_space(*inner)) count(static_cast<Space&>(*inner), by);
}

bool still_locked(const Space& space)
{
    CallGuard::release_left();
    return space.locks > 0;
}

bool any_locked(const Space& space)
{
    if (is_locked(space)) return true;
    if (space.helped == 0) return false;
    return std::any_of(space.geoms.begin(), space.geoms.end(), [](const Geom* inner) {
        return inner && is_space(*inner) && any_locked(static_cast<const Space&>(*inner));
    });
}

// Locks a space while its members get their boxes. If that is left, all have to be looked at later.
class Cleaning {
  public:
    explicit Cleaning(Space& space) : guard_(leave, &space), space_(space) { ++space.locks; }
    ~Cleaning()
    {
        if (guard_.end()) --space_.locks;
    }

  private:
    static void leave(void* id, const void*, std::size_t)
    {
        Space& space = *static_cast<Space*>(id);
        --space.locks;
        for (Geom* geom : space.geoms)
            if (geom) geom->queued = geom->box_stale = true;
        note_geoms_marked(space);
    }

    CallGuard guard_;
    Space& space_;
};

Space* space_from(dSpaceID id)
{
    Geom* geom = from_handle<Geom>(reinterpret_cast<dGeomID>(id));
    return !kChecked || (geom && is_space(*geom)) ? static_cast<Space*>(geom) : nullptr;
}

dSpaceID id_of(const Space* space) { return reinterpret_cast<dSpaceID>(to_handle<Geom>(space)); }

bool add_geom(Space& space, Geom& geom)
{
    if (!reserve_slots(space)) return false;
    geom.space = &space;
    geom.slot = space.geoms.size();
    note_structure_changed();
    geom.queued = false;
    (void)space.geoms.push(&geom);
    ++space.count;
    space.helped += !stands_alone(geom);
    mark_moved(geom);
    return true;
}

void remove_geom(Space& space, Geom& geom)
{
    space.geoms[geom.slot] = nullptr;
    note_structure_changed();
    space.broadphase.remove(geom.slot);
    note_disturbed(space, geom);
    geom.watched = 0;
    ++space.edition;
    geom.space = nullptr;
    geom.slot = -1;
    geom.queued = false;
    space.helped -= !stands_alone(geom);
    if (--space.count == 0) {
        space.geoms.clear();
        space.queue.clear();
        space.broadphase.clear();
    }
    mark_moved(space);
}

void empty_space(Space& space)
{
    for (int slot = space.geoms.size(); slot-- > 0;) {
        // The last member clears the list; a user's destructor function may take others with it.
        Geom* geom = slot < space.geoms.size() ? space.geoms[slot] : nullptr;
        if (!geom) continue;
        if (space.cleanup && !geom->dying)
            destroy_geom(*geom);
        else
            remove_geom(space, *geom);
    }
}

Geom* geom_at(Space& space, int index)
{
    if (has_gaps(space) && !is_locked(space)) (void)compact(space);
    if (!has_gaps(space)) return space.geoms[space.count - 1 - index];
    for (int slot = space.geoms.size(); slot-- > 0;)
        if (space.geoms[slot] && index-- == 0) return space.geoms[slot];
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

// Spaces are not watched: their members are.
void note_disturbed(Space& space, Geom& geom)
{
    if (!geom.watched && !is_space(geom)) return;
    geom.disturbed = next_disturbance();
    for (Space* above = &space; above; above = above->space) above->last_disturbed = geom.disturbed;
    if (geom.watched & kRestingPairs) space.disturbances.note(geom);
}

std::uint64_t next_disturbance() { return g_disturbances.fetch_add(1, std::memory_order_relaxed) + 1; }

void enqueue(Space& space, Geom& geom)
{
    // Room was made when the member joined; only a move during the cleaning itself may need more.
    geom.queued = space.queue.push(geom.slot);
    ++space.edition;
}

void note_geoms_marked(Space& space)
{
    space.unlisted = true;
    note_geoms_listed(space);
}

void note_geoms_listed(Space& space)
{
    ++space.edition;
    mark_moved(space);
}

void note_rules_changed(Geom& geom)
{
    // They are part of what a transform that holds the geom is.
    for (TransformGeom* holder = geom.holders; holder; holder = holder->next_holder) mark_changed(*holder);
    if (geom.space) note_disturbed(*geom.space, geom);
    for (Space* space = geom.space; space; space = space->space) ++space->edition;
}

void clean(Space& space)
{
    if (is_clean(space) || is_locked(space)) return;
    const Cleaning cleaning(space);
    list_queued(space);
    clean_queued(space, [](const Geom&) { return true; });
}

void clean(Space& space, const WayFinder& finder, const Tasks& tasks)
{
    const bool moves = !is_clean(space) && !is_locked(space);
    const Cleaning cleaning(space);
    if (moves && space.helped > 0) {
        list_queued(space);
        clean_queued(space, [](const Geom& geom) { return !stands_alone(geom); });
    } else if (moves) {
        space.queue.clear();
        space.unlisted = false;
    }
    Broadphase& boxes = space.broadphase;
    const int count = space.geoms.size();
    Geom* const* geoms = space.geoms.data();
    boxes.note_all(tasks, count, [&](int slot, Broadphase::Notes& notes) {
        constexpr int kAhead = 6;
        const auto geom_in = [&](int i) { return i < count ? geoms[i] : nullptr; };
        if (const Geom* soon = geom_in(slot + 2 * kAhead)) prefetch_shape(*soon), prefetch<1>(&soon->body);
        if (const Geom* next = geom_in(slot + kAhead))
            prefetch<5>(next->body.id), boxes.prefetch_fat_box(slot + kAhead);
        Geom* geom = geoms[slot];
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
    for (Geom* m : space.geoms) {
        if (!m) continue;
        all = first ? box_of(*m) : merge(all, box_of(*m));
        first = false;
    }
    return all;
}

}  // namespace epode
