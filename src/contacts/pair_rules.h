// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Common queries about pairs of geoms and their manifolds.
#pragma once

#include <algorithm>
#include <atomic>

#include "collide/solid_type.h"
#include "collide/transform.h"
#include "contacts/contact_pair.h"
#include "contacts/pair_finder.h"
#include "dynamics/world.h"

namespace epode {

// Allowed depth of world-managed contacts, m.
inline Real contact_layer(const World& world)
{
    return world.contact_layer > 0 ? world.contact_layer : Real(2e-4);
}

inline Body* body_of(const Geom& geom) { return from_handle<Body>(geom.body.id); }

// Null: it has none, or one of another world in the same space.
inline Body* own_body(const World& world, const Geom& geom)
{
    Body* const body = body_of(geom);
    return body && body->world == &world ? body : nullptr;
}

inline bool awake(const Body* body) { return body && !body->disabled; }

inline bool moves(const Body* body) { return body && !body->kinematic(); }

// What of it touches is no point of the body, as corners are, but wherever its surface comes nearest.
inline bool is_round(const Geom& geom) { return is_solid(geom) && geom.type->solid->round; }

// Points that do not touch yet are where the two will, on the surface of the one that moves. Between two that
// move, points stay fixed in both: their arms hold the angular momentum.
inline bool rounds_on_what_stands(const ContactPair& pair)
{
    return (!moves(pair.body1) || !moves(pair.body2)) &&
           (is_round(*from_handle<Geom>(pair.id1)) || is_round(*from_handle<Geom>(pair.id2)));
}

// Rays measure; they exert no force.
inline bool can_push(const Geom& geom) { return !is_ray(geom); }

inline bool is_surface(const Geom& geom)
{
    return geom.type->number == dTriMeshClass || geom.type->number == dHeightfieldClass;
}

inline bool on_mesh(const GeomPair& pair)
{
    const auto meets = [](const Geom& solid, const Geom& mesh) {
        return mesh.type->number == dTriMeshClass && is_solid(solid);
    };
    return meets(*pair.a, *pair.b) || meets(*pair.b, *pair.a);
}

inline int max_manifolds(const GeomPair& pair)
{
    return is_surface(*pair.a) || is_surface(*pair.b) ? kSurfaceManifolds : 1;
}

// By any worker of an update.
inline void watch(const ContactPair& pair, WatchedFor why)
{
    for (const dGeomID id : {pair.id1, pair.id2}) {
        const std::atomic_ref<std::uint8_t> watched(from_handle<Geom>(id)->watched);
        if (!(watched.load(std::memory_order_relaxed) & why))
            watched.fetch_or(why, std::memory_order_relaxed);
    }
}

inline SlotPair slots_of(const ContactPair& pair)
{
    const int a = from_handle<Geom>(pair.id1)->slot, b = from_handle<Geom>(pair.id2)->slot;
    return {std::max(a, b), std::min(a, b)};
}

// What is open and has not been pushed was only near. (Friction may be left of a normal impulse that is gone:
// step/island/problem/manifold_rows.cpp.)
inline bool touches(const CachedManifold& kept, const ManifoldPoint& point)
{
    const Float3 f = point.friction_impulse;
    return point.normal_impulse > 0 || point.separation <= kept.layer || f.x != 0 || f.y != 0 || f.z != 0;
}

inline bool touches(std::span<const CachedManifold> manifolds)
{
    for (const CachedManifold& kept : manifolds)
        for (int i = 0; i < kept.manifold.count; ++i)
            if (touches(kept, kept.manifold.points[i])) return true;
    return false;
}

}  // namespace epode
