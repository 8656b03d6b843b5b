// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/active_geoms.h"

namespace epode {

bool ActiveGeoms::gather(const World& world, const Space& space, std::uint64_t since)
{
    clear();
    if (listed_.size() < space.geoms.size() && !listed_.resize(space.geoms.size())) return false;
    bool complete = true;
    world.bodies.for_each_active([&](const Body& body) {
        for_each_geom_from(body.first_geom, [&](const Geom& geom) {
            if (geom.space == &space) complete = add(geom.slot) && complete;
        });
    });
    for (std::uint64_t i = since; i < space.disturbances.count(); ++i) {
        const auto& [id, serial] = space.disturbances[i];
        const Geom* geom = from_handle<Geom>(id);
        if (geom && geom->serial == serial && geom->space == &space) complete = add(geom->slot) && complete;
    }
    return complete;
}

bool ActiveGeoms::add(int slot)
{
    if (listed_.data()[slot]) return true;
    if (!slots_.push(slot)) return false;
    listed_.data()[slot] = 1;
    return true;
}

void ActiveGeoms::clear()
{
    for (const int slot : slots_) listed_.data()[slot] = 0;
    slots_.clear();
}

}  // namespace epode
