// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/pair_finder.h"

#include <bit>

#include "base/ahead.h"
#include "base/hash.h"

namespace epode {
namespace {

struct Collection {
    Array<GeomPair>& pairs;
    const Foresight& soon;
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

// Room in the broad phase for the whole way of what moves.
void expect_motion(Space& space, const Foresight& soon)
{
    constexpr int kAhead = 3;
    const int count = space.members.size();
    Geom* const* members = space.members.data();
    for (int slot = 0; slot < count; ++slot) {
        if (slot + 2 * kAhead < count) fetch<3>(members[slot + 2 * kAhead]);
        if (slot + kAhead < count && members[slot + kAhead]) fetch<8>(members[slot + kAhead]->body.id);
        const Geom* geom = members[slot];
        if (!geom || !space.broadphase.present(slot)) continue;
        const Body* body = from_handle<Body>(geom->body.id);
        const Aabb now = space.broadphase.box(slot);
        if (body) space.broadphase.expect(slot, body->disabled ? now : merge(now, soon.box(body, now)));
    }
}

void collect_inside(Space& space, Collection& into)
{
    expect_motion(space, into.soon);
    collide_space(space, &into, collect, PairsOf::kWays);
    const SpaceLock lock(space);
    for (Geom* member : space.members)
        if (member && member->enabled && is_space(*member))
            collect_inside(static_cast<Space&>(*member), into);
}

}  // namespace

bool find_geom_pairs(Space& space, const Foresight& soon, Array<GeomPair>& out)
{
    out.clear();
    Collection into{out, soon};
    collect_inside(space, into);
    return into.complete;
}

void DeepLock::count(Space& space, int by)
{
    space.locks += by;
    for (Geom* member : space.members)
        if (member && is_space(*member)) count(static_cast<Space&>(*member), by);
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
