// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contact events with their physics. Of a pair with points i, normals n_i and normal impulses p_i of the whole
// step,
//   impulse          sum p_i                              along the normals, so the sum of their lengths
//   pos, normal      sum p_i x_i / sum p_i, and the direction of sum p_i n_i; if nothing was exerted, the means;
//                    x_i where the points are after the step: before it they may still have been apart
//   approach_speed   max(0, max_i -n_i . u_i),   u_i = v1 + w1 x r1 - v2 - w2 x r2   before the step
// The velocities are gone when the impulses are known, so the speeds are measured between the search for
// islands and the solution, and only for worlds that list events.
//
// Whole impulses of pairs (PairImpulse) are those of the anchors at the present poses (place_again), which a state restores too, so
// what follows from them has the same bits after a roll-back.
#include <algorithm>

#include "contacts/contact_world.h"
#include "contacts/pair_rules.h"
#include "dynamics/impulse.h"

namespace epode {
namespace {

Vec3 velocity_at(const Body* body, Float3 arm)
{
    return body ? body->velocity() + cross(body->angular_velocity(), widen(arm)) : Vec3{};
}

// Where a point is after the step: it goes along with the one that moves, from the surface of that one.
Vec3 place_after(const ContactPair& pair, const CachedManifold& kept, const ManifoldPoint& point)
{
    const Vec3 at = kept.origin + widen(point.r1), n = widen(kept.manifold.normal);
    const Vec3 way1 = pair.body1->position() - kept.origin;
    const Vec3 way2 = pair.body2 ? pair.body2->position() - (at - widen(point.r2)) : Vec3{};
    if (moves(pair.body1) && moves(pair.body2)) return at + Real(0.5) * (way1 + way2);
    const bool on_surface = point.separation <= kept.layer || rounds_on_what_stands(pair);
    const Vec3 gap = on_surface ? Vec3{} : Real(0.5) * Real(point.separation - kept.layer) * n;
    return moves(pair.body1) ? at + gap + way1 : at - gap + way2;
}

Real exerted_by(std::span<const CachedManifold> manifolds)
{
    Real sum = 0;
    for (const CachedManifold& kept : manifolds)
        for (int i = 0; i < kept.manifold.count; ++i) sum += Real(kept.manifold.points[i].normal_impulse);
    return sum;
}

bool is_live(const ContactPair& pair)
{
    const Geom *g1 = from_handle<Geom>(pair.id1), *g2 = from_handle<Geom>(pair.id2);
    return g1 && g2 && g1->serial == pair.serial1 && g2->serial == pair.serial2 && body_of(*g1);
}

// m u, 1 / m = n . (K1 + K2) n at the place, u the approach along n.
Real remaining_at(const PairImpulse& at)
{
    const Body* const body1 = body_of(*from_handle<Geom>(at.g1));
    const Body* const body2 = own_body(*body1->world, *from_handle<Geom>(at.g2));
    Vec3 u = body1->point_velocity(at.place);
    Real yields = yielding(*body1, at.place - body1->position(), at.normal);
    if (body2) u -= body2->point_velocity(at.place);
    if (body2) yields += yielding(*body2, at.place - body2->position(), at.normal);
    const Real approach = -dot(at.normal, u);
    return approach > 0 && yields > 0 ? approach / yields : 0;
}

// At the mean of the points, by their normal impulses.
PairImpulse impulse_of(const ContactPair& pair, std::span<const CachedManifold> manifolds, Real exerted)
{
    PairImpulse out{pair.id1, pair.id2, {}, {}, {}, exerted, 0};
    for (CachedManifold placed : manifolds) {
        place_again(pair, placed);
        for (int i = 0; i < placed.manifold.count; ++i) {
            const ManifoldPoint& point = placed.manifold.points[i];
            const Real p = Real(point.normal_impulse);
            out.place += p / exerted * (placed.origin + widen(point.r1));
            out.normal += p * widen(placed.manifold.normal);
            out.on_first += widen(point.friction_impulse);
        }
    }
    out.on_first += out.normal;
    if (normalize(out.normal)) out.remaining = remaining_at(out);
    return out;
}

}  // namespace

bool ContactWorld::measure_approach(const Tasks& tasks)
{
    approach_.clear();
    if (!approach_.extend(fresh_.manifolds.size())) return false;
    tasks.each_of(fresh_.pairs.size(), kPairRange, [&](std::size_t p) {
        const ContactPair& pair = fresh_.pairs.data()[p];
        for (int m = pair.first; m < pair.first + pair.count; ++m) {
            const ContactManifold& manifold = fresh_.manifolds.data()[m].manifold;
            for (int i = 0; i < manifold.count; ++i) {
                const ManifoldPoint& point = manifold.points[i];
                const Vec3 u = velocity_at(pair.body1, point.r1) - velocity_at(pair.body2, point.r2);
                approach_.data()[m].at[i] = -dot(widen(manifold.normal), u);
            }
        }
    });
    return true;
}

dEvent ContactWorld::impact_of(const ContactPair& pair) const
{
    Real weight = 0, impulse = 0, approach = 0;
    Vec3 place, normal, mean_place, mean_normal;
    for (int m = pair.first; m < pair.first + pair.count; ++m) {
        const CachedManifold& kept = last_.manifolds.data()[m];
        const Vec3 n = widen(kept.manifold.normal);
        for (int i = 0; i < kept.manifold.count; ++i) {
            const ManifoldPoint& point = kept.manifold.points[i];
            if (!touches(kept, point)) continue;
            const Vec3 x = place_after(pair, kept, point);
            const Real p = Real(point.normal_impulse);
            ++weight, impulse += p;
            place += p * x, normal += p * n, mean_place += x, mean_normal += n;
            approach = std::max(approach, approach_.data()[m].at[i]);
        }
    }
    dEvent event{};
    if (weight == 0) return event;
    Vec3 direction = impulse > 0 ? normal : mean_normal;
    if (!normalize(direction)) direction = widen(last_.manifolds.data()[pair.first].manifold.normal);
    store(event.pos, impulse > 0 ? place / impulse : mean_place / weight);
    store(event.normal, direction);
    event.approach_speed = approach, event.impulse = impulse;
    return event;
}

// Just after accept(): what has not been taken over is still in the other list. Begins and ends come before
// what persists (event_list.h).
void ContactWorld::report(EventList& out) const
{
    const dEventSettings& settings = out.settings();
    const auto add = [&](const ContactPair& pair, dEventKind kind) {
        dEvent event = kind == dEventContactEnd ? dEvent{} : impact_of(pair);
        const bool counts =
            event.impulse >= settings.min_impulse && event.approach_speed >= settings.min_approach_speed;
        if (!counts && kind != dEventContactEnd) return;
        event.kind = kind, event.g1 = pair.id1, event.g2 = pair.id2;
        out.add({event, pair.serial1, pair.serial2});
    };
    if (out.wants(dEventContactEnd))
        for (const ContactPair& pair : fresh_.pairs)
            if (pair.old != kTakenOver && touches(fresh_.of(pair))) add(pair, dEventContactEnd);
    for (const bool persisting : {false, true}) {
        if (persisting && !out.wants(dEventContactPersist)) continue;
        for (const ContactPair& pair : last_.pairs) {
            if (pair.count == 0 && !pair.touched) continue;
            const bool now = touches(last_.of(pair));
            if ((now && pair.touched) != persisting || (!now && !pair.touched)) continue;
            const dEventKind kind = persisting ? dEventContactPersist
                                    : now      ? dEventContactBegin
                                               : dEventContactEnd;
            if (out.wants(kind) && (awake(pair.body1) || awake(pair.body2))) add(pair, kind);
        }
    }
}

bool ContactWorld::impulses(std::span<const std::uint64_t> geoms, Array<PairImpulse>& out) const
{
    const auto has = [&](std::uint64_t serial) {
        return std::binary_search(geoms.begin(), geoms.end(), serial);
    };
    for (const ContactPair& pair : last_.pairs) {
        if (pair.count == 0 || !(has(pair.serial1) || has(pair.serial2)) || !is_live(pair)) continue;
        const Real exerted = exerted_by(last_.of(pair));
        if (exerted > 0 && !out.push(impulse_of(pair, last_.of(pair), exerted))) return false;
    }
    return true;
}

}  // namespace epode
