// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See curved_overlap.h.
#include "geometry/overlap/curved_overlap.h"

#include "geometry/overlap/flat_overlap.h"
#include "geometry/overlap/gjk.h"

namespace epode {

namespace {

constexpr Real kValley = Real(2e-5);                      // of the size: by how much a valley may be missed
constexpr Real kGap = kSingle ? Real(1e-2) : Real(1e-3);  // of the size
constexpr int kRounds = 16;
// Of the distance. An angle t between n and the direction of the nearest points is worth t^2 (R + g) / g of
// it, so this is a millionth where R is the size, and of the depth the square of that.
constexpr Real kNearEnough = kSingle ? 64 * kEpsilon : Real(1e-10);

// The face normals that v names by its axes. v is a (`sense` -1) or b (1).
void offer_axes(const ConvexView& v, Real sense, const ConvexView& a, const ConvexView& b, Real handicap,
                Overlap& best)
{
    const auto offer = [&](Vec3 n) {
        const Real h = extent(a, b, n).h;
        if (h + handicap < best.depth) best.depth = h, best.normal = n;
    };
    for (int i = 0; i < 3; ++i) {
        const Vec3 axis = sense * v.pose.R.column(i);
        if (v.face_axes >> i & 1) offer(axis);
        if ((v.face_axes | v.base_axes) >> i & 1) offer(-axis);
    }
}

Vec3 normal_across(const ConvexView& a, const ConvexView& b, Real gap, const Overlap& at)
{
    ConvexView apart = a;
    apart.pose.p += (at.depth + gap) * at.normal;
    const Distance d = gjk_distance(apart, b, kInf, kNearEnough);
    Vec3 n = kSingle ? d.normal : d.on_a - d.on_b;
    return d.distance > 0 && normalize(n) ? n : at.normal;
}

void find_floor(const ConvexView& a, const ConvexView& b, Overlap& best)
{
    const Real gap = kGap * (a.size + b.size);
    for (int i = 0; i < kRounds; ++i) {
        const Vec3 n = normal_across(a, b, gap, best);
        const Real h = extent(a, b, n).h;
        if (!(h < best.depth)) return;
        best = {n, h};
    }
}

}  // namespace

Overlap curved_overlap(const ConvexView& a, const ConvexView& b, Real enough)
{
    const Real size = a.size + b.size, handicap = kPreference * size;
    Overlap flat;
    offer_axes(a, -1, a, b, 0, flat);
    offer_axes(b, 1, a, b, handicap, flat);
    if (flat.depth < enough) return flat;
    Overlap least = flat;
    // Apart by less than the polytope tells; so near that it crawls, the direction may still be a rough one.
    const Distance d = gjk_distance(a, b, kInf, kNearEnough);
    Vec3 between = kSingle ? d.normal : d.on_a - d.on_b;
    if (d.distance > 0 && normalize(between)) {
        const Real h = extent(a, b, between).h;
        if (h < least.depth) least = {between, h};
        if (h < 0) return least;
    }
    expand(a, b, kValley * size, enough, least);
    if (least.depth < enough) return least;
    Overlap flush;
    offer_face(a, -1, least.normal, a, b, flush);
    offer_face(b, 1, least.normal, a, b, flush);
    if (flush.depth < flat.depth) flat = flush;
    find_floor(a, b, least);
    return flat.depth <= least.depth + handicap ? flat : least;
}

}  // namespace epode
