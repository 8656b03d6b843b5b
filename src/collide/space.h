// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A space: a geom that holds geoms. All four classes of the interface (simple, hash, sweep and prune,
// quadtree) are this one structure: they promise the same pairs and differ only in what their users may
// expect of speed, and the broadphase serves each of them; levels, centres and axis orders are kept and
// answered, nothing more.
//   geoms     the members, by slots in order of joining. A slot is not used twice until compact() closes the
//             gaps, so that work lists may name slots.
//   locks     count the collisions in progress. A locked space refuses every change of its members, and is
//             not cleaned: it looks as it was when the outermost collision began. is_locked() also knows of
//             collisions that a function of the program has left.
#pragma once

#include "base/call_guard.h"
#include "base/prefetch.h"
#include "collide/broadphase.h"
#include "collide/geom.h"
#include "collide/user_class.h"

namespace epode {

inline constexpr int kMostNested = 100;  // spaces in spaces, transforms in transforms

// Members with pairs at rest (kRestingPairs) that have moved or left, or whose rules have changed: the last
// few of them.
class Disturbances {
  public:
    static constexpr int kKept = 256;
    struct Entry {
        dGeomID id;
        std::uint64_t serial;
    };

    void note(const Geom& geom) { entries_[count_++ % kKept] = {to_handle(&geom), geom.serial}; }
    std::uint64_t count() const { return count_; }
    bool knows_since(std::uint64_t earlier) const { return count_ - earlier <= kKept; }
    const Entry& operator[](std::uint64_t i) const { return entries_[i % kKept]; }

  private:
    Entry entries_[kKept];
    std::uint64_t count_ = 0;
};

struct Space : Geom {
    explicit Space(const GeomType& space_type) : Geom(space_type) {}

    Array<Geom*> geoms;     // by slot; null: a gap
    Array<int> queue;       // slots of members that have moved
    bool unlisted = false;  // members are marked as queued that are not in the queue
    Array<int> scratch;     // for answers of queries; whoever uses it swaps it out
    Broadphase broadphase;
    int count = 0;   // members without the gaps
    int helped = 0;  // of them that do not stand alone
    int locks = 0;
    int pair_walks = 0;  // walks over the pair list in progress
    int tried = 0;       // calls in a row that have tried all pairs
    int sublevel = 0;
    bool cleanup = true;        // destroys its members with itself
    std::uint64_t edition = 0;  // another one when something has happened that may change its pairs
    Disturbances disturbances;
    std::uint64_t last_disturbed = 0;  // of all members, at any depth: the greatest Geom::disturbed
    const void* keeper = nullptr;      // the only one who keeps pairs at rest; null: nobody
    int min_level = -3, max_level = 10;
};

// Keeps a space locked for the time of a scope, if functions of the program can be called in it.
class SpaceLock {
  public:
    explicit SpaceLock(Space& space, bool called = true) : guard_(called ? unlock : nullptr, &space)
    {
        space.locks += called;
    }

  private:
    static void unlock(void* space, const void*, std::size_t) { --static_cast<Space*>(space)->locks; }
    CallGuard guard_;
};

// Keeps a space and all in it, at any depth, locked.
class DeepLock {
  public:
    explicit DeepLock(Space& space) : guard_(unlock, &space) { count(space, 1); }

  private:
    static void count(Space& space, int by);
    static void unlock(void* space, const void*, std::size_t) { count(*static_cast<Space*>(space), -1); }
    CallGuard guard_;
};

[[gnu::cold]] bool still_locked(const Space& space);
inline bool is_locked(const Space& space) { return space.locks > 0 && still_locked(space); }
bool any_locked(const Space& space);  // it or one in it, at any depth

// The space that holds all that the geom is in; null: it is in none.
inline Space* outermost_space(const Geom& geom)
{
    Space* space = geom.space;
    while (space && space->space) space = space->space;
    return space;
}

// Whether the space is neither being collided nor being destroyed.
inline bool accepts_geoms(const Space& space) { return !is_locked(space) && !is_dying(space); }

Space* space_from(dSpaceID id);  // null unless it is a live space
dSpaceID id_of(const Space* space);

// ---- members; the caller has checked the locks ----
bool add_geom(Space& space, Geom& geom);  // false when memory is exhausted
void remove_geom(Space& space, Geom& geom);
void empty_space(Space& space);                        // destroys or lets go all members, as `cleanup` says
Geom* geom_at(Space& space, int index);                // newest first
bool is_inside(const Geom& geom, const Space& space);  // at any depth, or the space itself
bool nesting_fits(const Space& space, const Space& inner);  // functions that walk down call themselves

// ---- boxes ----
void enqueue(Space& space, Geom& geom);  // the member has moved
// Something other than a step has happened to the member: if its pairs rest, the next step looks at them
// again, and what sleeps on it wakes. Disturbances have numbers in the order in which they happen,
// of which other events take one, too.
void note_disturbed(Space& space, Geom& geom);
std::uint64_t next_disturbance();
// After many members have moved, any worker may mark a member that stands alone (false if it does not)
// without listing it. note_geoms_marked() must follow.
inline bool mark_geom(Geom& geom, const Space& space);
void note_geoms_marked(Space& space);
void note_geoms_listed(Space& space);  // the same, if each of them is in the queue
// Is no member, at any depth, waiting for the next cleaning?
inline bool is_clean(const Space& space) { return !space.unlisted && space.queue.empty(); }
// Something that decides about pairs of the geom has changed, and is not its place or shape.
void note_rules_changed(Geom& geom);
void clean(Space& space);  // gives every queued member its box, at all depths
// Whether box and pairs depend on the geom only: no space or transform, and not of a class of the program.
inline bool stands_alone(const Geom& geom)
{
    const int number = geom.type->number;
    return !is_space(geom) && number != dGeomTransformClass && !is_user_class(number);
}
// The swept box of each member, from any worker; it contains the box.
struct WayFinder {
    const void* data;
    Aabb (*way)(const void* data, const Geom& geom, const Aabb& box);
};
// The same as clean(), except that a locked space is not cleaned; then sets the swept boxes of all members.
void clean(Space& space, const WayFinder& finder, const Tasks& tasks);
Aabb space_aabb(Geom& space);  // a GeomType's function

// ---- collision ----
bool can_pair(Geom& a, Geom& b);  // all that decides but enabling, boxes and bits
bool may_meet(Geom& a, Geom& b);  // and bits
// Which boxes of two members must overlap: their own or their swept boxes.
enum class PairsOf { kBoxes, kSweptBoxes };
// visit(a, b) for the pairs first ... last - 1 of the broadphase's list that are there and may meet.
template <typename Visit>
void visit_pairs(Space& space, PairsOf of, std::size_t first, std::size_t last, Visit&& visit);
// Of so few members that many of them have left their places in the tree, all pairs are tried sooner than new
// places found. Those that move slowly stay for long where they are put, so that is tried from time to time.
bool try_all_pairs(Space& space);
void collide_space(Space& space, void* data, dNearCallback* callback, PairsOf of = PairsOf::kBoxes);
void collide_across(Geom& first, Geom& second, void* data, dNearCallback* callback);

inline bool mark_geom(Geom& geom, const Space& space)
{
    if (geom.space != &space || geom.holders || !stands_alone(geom)) return false;
    geom.pose_stale = geom.offset != nullptr;
    geom.box_stale = geom.queued = true;
    return true;
}

template <typename Visit>
void visit_pairs(Space& space, PairsOf of, std::size_t first, std::size_t last, Visit&& visit)
{
    // How many pairs before its turn a pair's boxes are fetched and compared, if they meet its geoms are
    // fetched (the lines that may_meet() and most visitors read), and their poses.
    constexpr std::size_t kBoxes = 16, kGeoms = 8, kPoses = 3;
    const Broadphase& boxes = space.broadphase;
    Geom* const* geoms = space.geoms.data();
    const SlotPair* pairs = boxes.pairs().data();
    const auto box_of = [&](int slot) -> const Aabb& {
        return of == PairsOf::kSweptBoxes ? boxes.way(slot) : boxes.box(slot);
    };
    const auto near = [&](std::size_t i) { return overlap(box_of(pairs[i].newer), box_of(pairs[i].older)); };
    unsigned ahead = 0;  // bit k: the pair k places ahead is near
    const auto look_ahead = [&](std::size_t i) {
        if (i + kBoxes - kGeoms < last) {
            const auto [newer, older] = pairs[i + kBoxes - kGeoms];
            prefetch<1>(&box_of(newer)), prefetch<1>(&box_of(older));
        }
        if (i >= last || !near(i)) return;
        prefetch<3>(geoms[pairs[i].newer]), prefetch<3>(geoms[pairs[i].older]);
        ahead |= 1u << kGeoms;
    };
    for (std::size_t i = first; i < first + kGeoms; ++i) look_ahead(i), ahead >>= 1;
    for (std::size_t i = first; i < last; ++i, ahead >>= 1) {
        look_ahead(i + kGeoms);
        if (of == PairsOf::kBoxes && (ahead >> kPoses & 1)) {
            const auto [newer, older] = pairs[i + kPoses];
            prefetch<3>(geoms[newer]->position), prefetch<3>(geoms[older]->position);
        }
        if (!(ahead & 1)) continue;
        const auto [newer, older] = pairs[i];
        Geom &a = *geoms[newer], &b = *geoms[older];
        if (a.enabled && b.enabled && may_meet(a, b)) visit(a, b);
    }
}

}  // namespace epode
