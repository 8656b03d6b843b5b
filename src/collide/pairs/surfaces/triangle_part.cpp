// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sutherland and Hodgman's cutting (1974) as in geometry/clip.h, with the mark of each corner carried along.
#include "collide/pairs/surfaces/triangle_part.h"

#include <utility>

namespace epode {

namespace {

// The part with normal . x <= limit + slack goes to `kept`; false where that is all of it.
bool cut(const TrianglePart& part, Vec3 normal, Real limit, Real slack, bool seam, TrianglePart& kept)
{
    Real distance[TrianglePart::kMax + 1];
    bool all = true;
    for (int i = 0; i < part.count; ++i) {
        distance[i] = dot(normal, part.points[i]) - limit;
        all = all && distance[i] <= slack;
    }
    if (all) return false;
    kept.count = 0;
    for (int i = 0; i < part.count; ++i) {
        const bool in = distance[i] <= slack;
        if (in) kept.add(part.points[i], part.seam[i]);
        const int j = i + 1 < part.count ? i + 1 : 0;
        if (in == (distance[j] <= slack) || (part.count == 2 && i == 1)) continue;
        if ((in ? distance[i] : distance[j]) >= 0) continue;  // the kept end lies on the plane already
        const Real t = distance[i] / (distance[i] - distance[j]);
        kept.add(part.points[i] + t * (part.points[j] - part.points[i]), seam);
    }
    return true;
}

}  // namespace

Prism::Prism(const Triangle& f, Vec3 direction)
{
    for (int k = 0; k < 3; ++k) {
        out[k] = normalized_or(cross(f.edge(k), direction), {});
        limit[k] = dot(out[k], f.v[k]);
    }
}

Prism::Prism(const MeshFacet& f) : Prism(f, f.n)
{
    for (int k = 0; k < 3; ++k) seam[k] = f.rim[k] == Rim::kSeam;
}

void cut_to_prism(TrianglePart& part, const Prism& prism, bool seams, Real slack)
{
    TrianglePart other;
    TrianglePart *from = &part, *to = &other;
    for (int k = 0; k < 3 && from->count > 0; ++k)
        if (cut(*from, prism.out[k], prism.limit[k], slack, seams && prism.seam[k], *to)) std::swap(from, to);
    if (from == &part) return;
    part.count = 0;
    for (int i = 0; i < other.count; ++i) part.add(other.points[i], other.seam[i]);
}

}  // namespace epode
