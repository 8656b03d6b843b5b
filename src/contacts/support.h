// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What sleeps on something wakes when that is disturbed (note_disturbed() in collide/space.h): moved by the
// program, changed, removed. Nothing that a step does wakes a sleeper here: what moves by itself is awake, and
// reaches it through an island. Asked before a step's update, about the pairs of the step before.
#pragma once

#include "contacts/contact_world.h"
#include "contacts/pair_rules.h"

namespace epode {

// Null: it was destroyed, or has left the space.
inline Geom* geom_in(dGeomID id, const Space& space)
{
    Geom* const geom = from_handle<Geom>(id);
    return geom && is_inside(*geom, space) ? geom : nullptr;
}

// Since that disturbance. The spaces that hold it count, too.
inline bool is_disturbed(const Geom* geom, std::uint64_t since)
{
    if (!geom) return true;
    for (; geom; geom = geom->space)
        if (geom->disturbed > since) return true;
    return false;
}

// visit(geom) for the geoms of a pair whose body touches the other one, if that has been disturbed since. The
// body may be awake: what the program does to it before the next step is not known yet.
template <typename Visit>
void visit_unsupported(const ContactPair& pair, std::span<const CachedManifold> manifolds, const Space& space,
                       std::uint64_t since, Visit&& visit)
{
    Geom* const geoms[] = {geom_in(pair.id1, space), geom_in(pair.id2, space)};
    for (int i = 0; i < 2; ++i) {
        const Geom *const geom = geoms[i], *const other = geoms[1 - i];
        if (geom && geom->body.id && is_disturbed(other, since) && touches(manifolds)) visit(*geom);
    }
}

}  // namespace epode
