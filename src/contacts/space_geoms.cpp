// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/space_geoms.h"

#include <algorithm>

namespace epode {

bool SpaceGeoms::gather(Space* space)
{
    root_ = space;
    geoms_.clear(), deeper_.clear(), by_slot_.clear();
    if (!space) return true;
    if (!by_slot_.resize(space->geoms.size()) || !geoms_.reserve(space->count) || !add(*space)) return false;
    std::sort(deeper_.begin(), deeper_.end(),
              [](const Entry& a, const Entry& b) { return a.serial < b.serial; });
    return true;
}

bool SpaceGeoms::add(Space& space)
{
    constexpr int kAhead = 8;
    const int count = space.geoms.size();
    for (int slot = 0; slot < count; ++slot) {
        if (slot + kAhead < count) prefetch<1>(space.geoms.data()[slot + kAhead]);
        Geom* geom = space.geoms.data()[slot];
        if (!geom) continue;
        if (&space == root_)
            by_slot_.data()[slot] = geoms_.size();
        else if (!deeper_.push({geom->serial, geoms_.size()}))
            return false;
        if (!geoms_.push(geom) || (is_space(*geom) && !add(static_cast<Space&>(*geom)))) return false;
    }
    return true;
}

int SpaceGeoms::find(const Geom& geom) const
{
    if (geom.space == root_) return root_ ? by_slot_.data()[geom.slot] : -1;
    const Entry* at =
        std::lower_bound(deeper_.begin(), deeper_.end(), geom.serial,
                         [](const Entry& e, std::uint64_t serial) { return e.serial < serial; });
    return at != deeper_.end() && at->serial == geom.serial ? at->number : -1;
}

}  // namespace epode
