// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which pairs a space reports, and in which order: newer members before older ones, as a function of the
// order of joining alone. Where memory for the broadphase is lacking, and where few move much, all pairs are
// tried; that finds the same ones.
#include <algorithm>

#include "base/float_environment.h"
#include "collide/collide.h"
#include "collide/space.h"

namespace epode {
namespace {

struct Report {
    void* data;
    dNearCallback* callback;
    void operator()(Geom& a, Geom& b) const
    {
        const CallerFloatEnvironment program;
        callback(data, to_handle(&a), to_handle(&b));
    }
};

// The callback may move and enable geoms, but not change the list.
void report_pairs(Space& space, const Report& report, PairsOf of)
{
    const CallGuard walk([](void* s, const void*, std::size_t) { --static_cast<Space*>(s)->pair_walks; },
                         &space);
    ++space.pair_walks;
    visit_pairs(space, of, 0, space.broadphase.pairs().size(), report);
}

void report_all_pairs(Space& space, const Report& report, PairsOf of)
{
    const Broadphase& boxes = space.broadphase;
    const auto box_of = [&](int slot) -> const Aabb& {
        return of == PairsOf::kSweptBoxes ? boxes.way(slot) : boxes.box(slot);
    };
    for (int i = space.geoms.size(); i-- > 0;) {
        if (!space.geoms[i] || !boxes.present(i)) continue;
        for (int j = i; j-- > 0;) {
            Geom *a = space.geoms[i], *b = space.geoms[j];
            if (!b || !boxes.present(j) || !overlap(box_of(i), box_of(j))) continue;
            if (a->enabled && b->enabled && may_meet(*a, *b)) report(*a, *b);
        }
    }
}

// visit(slot) for the members whose boxes meet the geom's; of a ray, for those of them that it meets itself
// (GeomType::may_touch) and few more. False when memory is exhausted.
template <typename Visit>
bool ask(Broadphase& boxes, Geom& geom, const Aabb& box, Visit&& visit)
{
    if (geom.type->number != dRayClass || rays_overridden()) return boxes.query(box, visit);
    if (!boxes.prepare(1)) return false;
    const Pose pose = pose_of(geom);
    Vec3 way = static_cast<const ShapeGeom<Ray>&>(geom).shape.length * pose.R.column(2);
    const Real length = epode::length(way);
    if (!normalize(way)) return boxes.query(box, visit);
    const Real reach = length * (1 + 8 * kEpsilon);
    const auto look = [&](int slot) {
        if (overlap(boxes.box(slot), box)) visit(slot);
        return reach;
    };
    boxes.cast(pose.p, way, reach, look, [&](int slot) { prefetch<1>(&boxes.box(slot)); });
    return true;
}

// Members of the space that meet a geom's box, newest first; the list lends the space's memory.
class Candidates {
  public:
    Candidates(Space& space, Geom& geom, const Aabb& box) : space_(space)
    {
        slots_.swap(space.scratch);
        slots_.clear();
        bool stored = true;
        const bool asked =
            ask(space.broadphase, geom, box, [&](int slot) { stored = slots_.push(slot) && stored; });
        complete_ = asked && stored;
        std::sort(slots_.begin(), slots_.end(), [](int a, int b) { return a > b; });
    }
    ~Candidates() { slots_.swap(space_.scratch); }
    Candidates(const Candidates&) = delete;
    Candidates& operator=(const Candidates&) = delete;

    template <typename Visit>
    void for_each(const Aabb& box, Visit&& visit) const
    {
        if (complete_) {
            for (int slot : slots_) visit(*space_.geoms[slot]);
            return;
        }
        for (int slot = space_.geoms.size(); slot-- > 0;)
            if (space_.geoms[slot] && space_.broadphase.present(slot) &&
                overlap(space_.broadphase.box(slot), box))
                visit(*space_.geoms[slot]);
    }

  private:
    Space& space_;
    Array<int> slots_;
    bool complete_ = false;
};

// Calls report(geom, candidate) for the enabled candidates of one geom.
template <typename Report>
void report_candidates(Space& space, Geom& geom, const Aabb& box, const Report& report)
{
    const Candidates candidates(space, geom, box);
    candidates.for_each(box, [&](Geom& m) {
        if (m.enabled && may_meet(geom, m)) report(geom, m);
    });
}

// A space against a geom, or against a space that is taken as a geom.
template <typename Report>
void space_with_geom(Space& space, Geom& geom, const Report& report)
{
    clean(space);
    const Aabb box = box_of(geom);
    SpaceLock lock(space);
    report_candidates(space, geom, box, report);
}

// Every pair across: walks the space with fewer members and queries the other one.
template <typename Report>
void space_with_space(Space& walked, Space& asked, const Report& report)
{
    clean(walked);
    clean(asked);
    SpaceLock lock_walked(walked), lock_asked(asked);
    for (int slot = walked.geoms.size(); slot-- > 0;) {
        Geom* geom = walked.geoms[slot];
        if (!geom || !geom->enabled || !walked.broadphase.present(slot)) continue;
        report_candidates(asked, *geom, walked.broadphase.box(slot), report);
    }
}

}  // namespace

bool try_all_pairs(Space& space)
{
    constexpr int kFew = 32, kInARow = 32;
    const int count = space.geoms.size();
    const bool yes = count <= kFew && 4 * space.broadphase.waiting() > count && space.tried < kInARow;
    space.tried = yes ? space.tried + 1 : 0;
    return yes;
}

bool can_pair(Geom& a, Geom& b)
{
    if (&a == &b || of_one_body(a, b)) return false;
    return !(a.type->may_touch && !a.type->may_touch(a, b)) &&
           !(b.type->may_touch && !b.type->may_touch(b, a));
}

bool may_meet(Geom& a, Geom& b)
{
    return ((a.category & b.collide) || (b.category & a.collide)) && can_pair(a, b);
}

void collide_space(Space& space, void* data, dNearCallback* callback, PairsOf of)
{
    const bool is_walked = is_locked(space) && space.pair_walks > 0;
    const bool moves = !is_clean(space);
    clean(space);
    SpaceLock lock(space);
    const Report report{data, callback};
    if (moves && of == PairsOf::kBoxes && try_all_pairs(space)) return report_all_pairs(space, report, of);
    // During a walk over the pair list it must stay; then it is up to date already.
    if (is_walked || space.broadphase.find_pairs())
        report_pairs(space, report, of);
    else
        report_all_pairs(space, report, of);
}

void collide_across(Geom& first, Geom& second, void* data, dNearCallback* callback)
{
    const Report report{data, callback};
    const GeomHold hold_first(first), hold_second(second);
    const auto swapped = [&](Geom& a, Geom& b) { report(b, a); };
    Space* s1 = is_space(first) ? static_cast<Space*>(&first) : nullptr;
    Space* s2 = is_space(second) ? static_cast<Space*>(&second) : nullptr;
    // Of two spaces the one of higher sublevel is opened.
    if (s1 && s2 && s1->sublevel != s2->sublevel) (s1->sublevel > s2->sublevel ? s2 : s1) = nullptr;

    if (!s1 && !s2) {
        if (overlap(box_of(first), box_of(second)) && may_meet(first, second)) report(first, second);
    } else if (!s2) {
        space_with_geom(*s1, second, swapped);
    } else if (!s1) {
        space_with_geom(*s2, first, report);
    } else if (s1 == s2) {
        collide_space(*s1, data, callback);
    } else if (s1->count < s2->count) {
        space_with_space(*s1, *s2, report);
    } else {
        space_with_space(*s2, *s1, swapped);
    }
}

}  // namespace epode
