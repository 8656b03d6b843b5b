// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A space: a geom that holds geoms. All four classes of the interface (simple, hash, sweep and prune,
// quadtree) are this one structure: they promise the same pairs and differ only in what their users may
// expect of speed, and the broadphase serves each of them; levels, centres and axis orders are kept and
// answered, nothing more.
//   members   slots in order of joining. A slot is not used twice until compact() closes the gaps, so that
//   work
//             lists may name slots.
//   locks     count the collisions in progress. A locked space refuses every change of its members, and is
//   not
//             cleaned: whoever looks sees it as it was when the outermost collision began.
#pragma once

#include "collide/broadphase.h"
#include "collide/geom.h"

namespace epode {

inline constexpr int kMostNested = 100;  // spaces in spaces, transforms in transforms

struct Space : Geom {
    explicit Space(const GeomType& space_type) : Geom(space_type) {}

    Array<Geom*> members;  // by slot; null: a gap
    Array<int> queue;      // slots of members that have moved
    Array<int> scratch;    // for answers of queries; whoever uses it swaps it out
    Broadphase broadphase;
    int count = 0;  // members without the gaps
    int locks = 0;
    int pair_walks = 0;  // walks over the pair list in progress
    int sublevel = 0;
    bool cleanup = true;  // destroys its members with itself
    bool manual_cleanup = false;
    int min_level = -3, max_level = 10;
};

// Keeps a space locked for the time of a scope.
class SpaceLock {
  public:
    explicit SpaceLock(Space& space) : space_(space) { ++space_.locks; }
    SpaceLock(const SpaceLock&) = delete;
    SpaceLock& operator=(const SpaceLock&) = delete;
    ~SpaceLock() { --space_.locks; }

  private:
    Space& space_;
};

// The space that holds all that the geom is in; null: it is in none.
inline Space* outermost_space(const Geom& geom)
{
    Space* space = geom.space;
    while (space && space->space) space = space->space;
    return space;
}

// Neither being collided nor being destroyed.
inline bool takes_members(const Space& space) { return space.locks == 0 && !space.dying; }

Space* space_from(dSpaceID id);  // null unless it is a live space
dSpaceID id_of(const Space* space);

// ---- members; the caller has checked the locks ----
bool add_member(Space& space, Geom& geom);  // false when memory is exhausted
void remove_member(Space& space, Geom& geom);
void empty_space(Space& space);                        // destroys or lets go all members, as `cleanup` says
Geom* member(Space& space, int index);                 // newest first
bool is_inside(const Geom& geom, const Space& space);  // at any depth, or the space itself
bool nesting_fits(const Space& space, const Space& inner);  // functions that walk down call themselves

// ---- boxes ----
void enqueue(Space& space, Geom& geom);  // the member has moved
void clean(Space& space);                // gives every queued member its box, at all depths
Aabb space_aabb(Geom& space);            // a GeomType's function

// ---- collision ----
bool may_meet(Geom& a, Geom& b);  // all that decides but enabling and boxes
// Which boxes of two members must overlap: their own, or those of the ways that are expected of them.
enum class PairsOf { kBoxes, kWays };
void collide_space(Space& space, void* data, dNearCallback* callback, PairsOf of = PairsOf::kBoxes);
void collide_across(Geom& first, Geom& second, void* data, dNearCallback* callback);

}  // namespace epode
