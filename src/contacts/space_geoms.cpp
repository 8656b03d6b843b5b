// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/space_geoms.h"

#include <algorithm>

namespace epode {

bool SpaceGeoms::gather(Space* space)
{
    geoms_.clear(), entries_.clear(), table_.clear();
    if (!space) return true;
    if (!geoms_.reserve(space->count) || !entries_.reserve(space->count) || !add(*space)) return false;
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.serial < b.serial; });
    return make_table();
}

bool SpaceGeoms::add(Space& space)
{
    constexpr int kAhead = 8;
    const int count = space.geoms.size();
    for (int slot = 0; slot < count; ++slot) {
        if (slot + kAhead < count) prefetch<1>(space.geoms.data()[slot + kAhead]);
        Geom* geom = space.geoms.data()[slot];
        if (!geom) continue;
        if (!entries_.push({geom->serial, geoms_.size()}) || !geoms_.push(geom) ||
            (is_space(*geom) && !add(static_cast<Space&>(*geom))))
            return false;
    }
    return true;
}

bool SpaceGeoms::make_table()
{
    constexpr std::uint64_t kWidest = 8;  // places for a geom
    if (entries_.empty()) return true;
    first_ = entries_[0].serial;
    const std::uint64_t places = entries_.back().serial - first_ + 1;
    if (places > kWidest * std::uint64_t(entries_.size())) return true;
    if (!table_.resize(int(places))) return false;
    std::fill(table_.begin(), table_.end(), -1);
    for (const Entry& e : entries_) table_[int(e.serial - first_)] = e.number;
    return true;
}

int SpaceGeoms::search(std::uint64_t serial) const
{
    const Entry* at = std::lower_bound(entries_.begin(), entries_.end(), serial,
                                       [](const Entry& e, std::uint64_t one) { return e.serial < one; });
    return at != entries_.end() && at->serial == serial ? at->number : -1;
}

}  // namespace epode
