// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The program's function of manifolds (dWorldSetManifoldFunction). Coefficients are combined from materials in every step, so what
// it changes lasts for one; a manifold that it rejects is taken out of its pair, as if the two did not touch there.
#include <algorithm>

#include "base/float_environment.h"
#include "contacts/contact_world.h"

namespace epode {
namespace {

Vec3 velocity_at(const Body* body, Vec3 place) { return body ? body->point_velocity(place) : Vec3{}; }

dManifold shown(const ContactPair& pair, const CachedManifold& kept)
{
    const ContactManifold& m = kept.manifold;
    dManifold out{};
    out.struct_size = sizeof out;
    out.g1 = pair.id1, out.g2 = pair.id2;
    out.touched = pair.touched, out.count = m.count, out.accept = 1;
    Vec3 mean;
    for (int i = 0; i < m.count; ++i) {
        const Vec3 place = kept.origin + widen(m.points[i].r1);
        store(out.pos[i], place);
        out.depth[i] = Real(kept.layer - m.points[i].separation);
        mean += (Real(1) / Real(m.count)) * place;
    }
    store(out.normal, widen(m.normal));
    store(out.velocity, velocity_at(pair.body1, mean) - velocity_at(pair.body2, mean));
    out.friction = m.mu, out.bounce = m.restitution, out.bounce_speed = m.restitution_threshold;
    out.rolling_friction = m.rolling_friction;
    out.compliance = m.compliance, out.damping_time = m.damping_time;
    store(out.surface_velocity, widen(m.surface_velocity));
    out.cross_friction = m.cross_mu, out.max_impulse = m.max_impulse;
    store(out.friction_axis, widen(m.friction_axis));
    return out;
}

// A coefficient that a material may have.
void take(Real from, Real largest, float& to)
{
    if (from >= 0 && from <= kInf) to = float(std::min(from, largest));
}

// Of the softest and most frictional materials (contacts/material.cpp).
constexpr Real kLargest = Real(1e6), kSoftestPoint = Real(1e9), kHardestPoint = Real(1e-9);

// An axis in the contact plane, or none where there is no difference along and across it.
void take_axis(const dManifold& from, ContactManifold& to)
{
    if (!usable(from.friction_axis, 3)) return;
    const Vec3 n = widen(to.normal), a = load(from.friction_axis), seen = a - dot(n, a) * n;
    constexpr Real kUpright = Real(1e-3);
    const bool has = to.mu != to.cross_mu && length2(seen) > kUpright * kUpright * length2(a);
    to.friction_axis = has ? narrow(normalized_or(seen, {})) : Float3{};
}

void take(const dManifold& from, ContactManifold& to)
{
    take(from.cross_friction, kLargest, to.cross_mu);
    take(from.max_impulse, kInf, to.max_impulse);
    take(from.friction, kLargest, to.mu);
    if (from.bounce <= 1) take(from.bounce, 1, to.restitution);
    take(from.bounce_speed, kInf, to.restitution_threshold);
    take(from.rolling_friction, kLargest, to.rolling_friction);
    take(from.compliance, kSoftestPoint, to.compliance);
    if (to.compliance < float(kHardestPoint)) to.compliance = 0;
    take(from.damping_time, kLargest, to.damping_time);
    take_axis(from, to);
    if (!usable(from.surface_velocity, 3)) return;
    const Vec3 n = widen(to.normal), u = load(from.surface_velocity);
    to.surface_velocity = narrow(u - dot(n, u) * n);
}

void show(const ContactPair& pair, CachedManifold& kept, dManifoldFunction* function, void* data)
{
    dManifold manifold = shown(pair, kept);
    function(data, &manifold);
    if (manifold.accept)
        take(manifold, kept.manifold);
    else
        kept.manifold.count = 0;
}

}  // namespace

void ContactWorld::show_manifolds(const Tasks& tasks)
{
    if (!function) return;
    const auto show_pair = [&](ContactPair& pair) {
        if (pair.shown || pair.count == 0) return;
        pair.shown = true;
        CachedManifold* const own = fresh_.manifolds.data() + pair.first;
        for (int i = 0; i < pair.count; ++i) show(pair, own[i], function, function_data);
        const auto is_empty = [](const CachedManifold& m) { return m.manifold.count == 0; };
        pair.count = std::uint8_t(std::remove_if(own, own + pair.count, is_empty) - own);
    };
    constexpr int kRange = 64;
    const Tasks alone(1);
    (function_on_threads ? tasks : alone).in_ranges(fresh_.pairs.size(), kRange, [&](int begin, int end) {
        const CallerFloatEnvironment program;
        for (int i = begin; i < end; ++i) show_pair(fresh_.pairs.data()[i]);
    });
}

}  // namespace epode
