// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/pair_finder.h"

#include <algorithm>
#include <bit>

#include "base/hash.h"

namespace epode {
namespace {

struct Collection {
    Array<GeomPair>& pairs;
    const SpeculativeMotion& soon;
    const Tasks& tasks;
    bool complete = true;
};

void collect(void* data, dGeomID o1, dGeomID o2)
{
    auto& into = *static_cast<Collection*>(data);
    Geom &a = *from_handle<Geom>(o1), &b = *from_handle<Geom>(o2);
    if (is_space(a) || is_space(b))
        collide_across(a, b, data, collect);
    else
        into.complete = into.pairs.push({&a, &b}) && into.complete;
}

Aabb way_of(const void* soon, const Geom& geom, const Aabb& box)
{
    const Body* body = from_handle<Body>(geom.body.id);
    return body->disabled ? box : merge(box, static_cast<const SpeculativeMotion*>(soon)->box(body, box));
}

// Where no member has to be opened or asked about, all workers go through the pairs.
bool collect_lone(Space& space, const Tasks& tasks, Array<GeomPair>& out)
{
    const int count = int(space.broadphase.pairs().size());
    if (!out.extend(count)) return false;
    GeomPair* const pairs = out.data();
    tasks.for_each((count + kPairRange - 1) / kPairRange, [&](int range, int) {
        const int first = range * kPairRange, last = std::min(count, first + kPairRange);
        GeomPair* to = pairs + first;
        visit_pairs(space, PairsOf::kSweptBoxes, std::size_t(first), std::size_t(last),
                    [&](Geom& a, Geom& b) {
                        *to++ = {&a, &b};
                    });
        if (to < pairs + last) to->a = nullptr;
    });
    return true;
}

bool bits_meet(const Geom& a, const Geom& b) { return (a.category & b.collide) || (b.category & a.collide); }

// In the order of the broad phase's list.
bool collect_few(const Space& space, Array<GeomPair>& out)
{
    const Broadphase& boxes = space.broadphase;
    for (int i = space.geoms.size(); i-- > 0;) {
        Geom* const a = space.geoms[i];
        if (!a || !a->enabled || !boxes.present(i)) continue;
        const Aabb way = boxes.way(i);
        for (int j = i; j-- > 0;) {
            Geom* const b = space.geoms[j];
            if (!b || !bits_meet(*a, *b) || !boxes.present(j) || !overlap(way, boxes.way(j))) continue;
            if (!b->enabled || !may_meet(*a, *b)) continue;
            if (!out.push({a, b})) return false;
        }
    }
    return true;
}

void collect_inside(Space& space, Collection& into)
{
    if (space.helped == 0 && into.pairs.empty() && try_all_pairs(space)) {
        into.complete = collect_few(space, into.pairs);
        return;
    }
    if (space.helped == 0 && into.pairs.empty() && space.broadphase.find_pairs(into.tasks)) {
        into.complete = collect_lone(space, into.tasks, into.pairs);
        return;
    }
    collide_space(space, &into, collect, PairsOf::kSweptBoxes);
    const SpaceLock lock(space);
    for (Geom* member : space.geoms)
        if (member && member->enabled && is_space(*member)) {
            expect_motion(static_cast<Space&>(*member), into.soon, into.tasks);
            collect_inside(static_cast<Space&>(*member), into);
        }
}

}  // namespace

void expect_motion(Space& space, const SpeculativeMotion& soon, const Tasks& tasks)
{
    clean(space, {&soon, way_of}, tasks);
}

bool find_geom_pairs(Space& space, const SpeculativeMotion& soon, const Tasks& tasks, Array<GeomPair>& out)
{
    out.clear();
    Collection into{out, soon, tasks};
    collect_inside(space, into);
    return into.complete;
}

void expect_motion(Space& space, const SpeculativeMotion& soon, const ActiveGeoms& active)
{
    clean(space);
    Broadphase& boxes = space.broadphase;
    for (const int slot : active.slots()) {
        const Geom& geom = *space.geoms[slot];
        if (geom.body.id && boxes.present(slot)) boxes.expect(slot, way_of(&soon, geom, boxes.box(slot)));
    }
}

bool find_geom_pairs(Space& space, const ActiveGeoms& active, Array<SlotPair>& near, Array<GeomPair>& out)
{
    out.clear();
    near.clear();
    Broadphase& boxes = space.broadphase;
    bool complete = true;
    const auto meet = [&](int a, int b) {
        Geom &first = *space.geoms[a], &second = *space.geoms[b];
        if (first.enabled && second.enabled && may_meet(first, second))
            complete = near.push({a, b}) && complete;
    };
    for (const int slot : active.slots()) {
        if (!boxes.present(slot)) continue;
        const bool found = boxes.query_way(slot, [&](int other) {
            if (other < slot || !active.has(other)) meet(std::max(slot, other), std::min(slot, other));
        });
        complete = found && complete;
    }
    std::sort(near.begin(), near.end(), in_order);
    complete = complete && out.extend(near.size());
    for (int i = 0; complete && i < near.size(); ++i)
        out[i] = {space.geoms[near[i].newer], space.geoms[near[i].older]};
    return complete;
}

bool RecordFinder::is(int record, std::uint64_t serial1, std::uint64_t serial2) const
{
    const ContactPair& r = records_.data()[record];
    return r.serial1 == serial1 && r.serial2 == serial2;
}

bool RecordFinder::make_table()
{
    const int size = int(std::bit_ceil(unsigned(records_.size()) * 2 + 2));
    table_.clear();
    if (!table_.resize(size)) return false;
    for (int& entry : table_) entry = -1;
    for (int i = 0; i < records_.size(); ++i) {
        std::size_t at = hash_of(records_[i].serial1, records_[i].serial2) & std::size_t(size - 1);
        while (table_.data()[at] >= 0) at = (at + 1) & std::size_t(size - 1);
        table_.data()[at] = i;
    }
    made_ = true;
    return true;
}

int RecordFinder::find(std::uint64_t serial1, std::uint64_t serial2)
{
    if (records_.empty()) return -1;
    int found = -1;
    if (next_ < records_.size() && is(next_, serial1, serial2)) {
        found = next_;
    } else {
        if (!made_ && !make_table()) return -2;
        const auto mask = std::size_t(table_.size() - 1);
        for (std::size_t at = hash_of(serial1, serial2) & mask; table_.data()[at] >= 0; at = (at + 1) & mask)
            if (is(table_.data()[at], serial1, serial2)) {
                found = table_.data()[at];
                break;
            }
    }
    if (found >= 0) next_ = found + 1;
    return found;
}

}  // namespace epode
