// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See separation.h.
#include "query/separation.h"

#include "geometry/overlap/epa.h"
#include "geometry/overlap/gjk.h"

namespace epode {
namespace {

// Adds the radii to what is known of the cores.
Separation inflated(const ConvexView& a, const ConvexView& b, Real core_distance, Vec3 on_a, Vec3 n)
{
    Separation s;
    s.distance = core_distance - a.radius - b.radius;
    s.normal = n;
    s.on_a = on_a - a.radius * n;
    s.on_b = s.on_a - s.distance * n;
    return s;
}

Separation overlapping(const ConvexView& a, const ConvexView& b)
{
    const Overlap o = least_overlap(a, b);
    const Real gap = (kSingle ? Real(1e-2) : Real(1e-3)) * (a.size + b.size);
    const Vec3 shift = (o.depth + gap) * o.normal;
    ConvexView moved = a;
    moved.pose.p += shift;
    const Distance d = gjk_distance(moved, b);
    const Vec3 on_a = d.distance > 0 ? d.on_a - shift : a.support(-o.normal);
    return inflated(a, b, -o.depth, on_a, o.normal);
}

}  // namespace

Separation separation(const ConvexView& a, const ConvexView& b, Real limit, LastDigits last)
{
    const Real radii = a.radius + b.radius;
    // A little more, so that what lies at the limit is not left out by rounding.
    const Real max_distance = limit + radii > 0 ? (1 + 64 * kEpsilon) * (limit + radii) : Real(0);
    const Distance d = gjk_distance(a, b, max_distance, 4 * kEpsilon, last);
    const Vec3 n = d.on_a - d.on_b;
    if (!(d.distance > 0)) return overlapping(a, b);
    if (d.distance > max_distance || !(length2(n) > 0)) return {};  // farther, found out early
    const Separation s = inflated(a, b, d.distance, d.on_a, kSingle ? d.normal : n / length(n));
    return s.distance <= limit ? s : Separation{};
}

Separation separation(const ConvexView& a, const Plane& b)
{
    const Vec3 core = a.support(-b.normal);
    Separation s;
    s.distance = dot(b.normal, core) - b.d - a.radius;
    s.normal = b.normal;
    s.on_a = core - a.radius * b.normal;
    s.on_b = s.on_a - s.distance * b.normal;
    return s;
}

}  // namespace epode
