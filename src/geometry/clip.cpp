// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Polygon clipping: see clip.h. Every vertex is kept or dropped by its own signed distance, and each edge
// whose ends differ adds one point, so the order of the survivors follows the order of the input.
#include "geometry/clip.h"

namespace epode {

namespace {

template <typename Distance>
void clip_by(Polygon& polygon, Real slack, const Distance& distance_of)
{
    const int count = polygon.count;
    if (count == 0) return;
    Real distance[Polygon::kMax];
    bool all = true;
    for (int i = 0; i < count; ++i) {
        distance[i] = distance_of(polygon.points[i]);
        all = all && distance[i] <= slack;
    }
    if (all) return;
    union Copy {
        Vec3 points[Polygon::kMax];
        Copy() {}
    } old;
    for (int i = 0; i < count; ++i) old.points[i] = polygon.points[i];
    polygon.count = 0;
    for (int i = 0; i < count; ++i) {
        const bool in = distance[i] <= slack;
        if (in) polygon.add(old.points[i]);
        const int j = i + 1 < count ? i + 1 : 0;
        if (in == (distance[j] <= slack) || (count == 2 && i == 1)) continue;
        const Real inside = in ? distance[i] : distance[j];
        const Real d = distance[i] - distance[j];
        if (inside >= 0) continue;  // the kept end lies on the plane already
        polygon.add(old.points[i] + (distance[i] / d) * (old.points[j] - old.points[i]));
    }
}

}  // namespace

void clip(Polygon& polygon, Vec3 normal, Real limit, Real slack)
{
    clip_by(polygon, slack, [&](Vec3 p) { return dot(normal, p) - limit; });
}

void clip(Polygon& polygon, int axis, Real sign, Real limit, Real slack)
{
    clip_by(polygon, slack, [&](Vec3 p) { return sign * p[axis] - limit; });
}

void clip_to_prism(Polygon& polygon, const Polygon& reference, Vec3 normal, Real slack)
{
    for (int i = 0; i < reference.count && polygon.count > 0; ++i) {
        const Vec3 p = reference.points[i], q = reference.points[i + 1 < reference.count ? i + 1 : 0];
        const Vec3 outward = cross(q - p, normal);
        const Real size2 = length2(outward);
        if (!(size2 > 0)) continue;
        const Vec3 unit = outward / std::sqrt(size2);
        clip(polygon, unit, dot(unit, p), slack);
    }
}

}  // namespace epode
