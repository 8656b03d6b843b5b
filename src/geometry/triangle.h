// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A triangle v0, v1, v2, counter-clockwise about its unit normal n; its plane is n . x = c. Seen as a convex
// solid it is flat: support points and the one face, no radius.
// The prism of a triangle about a direction d are all points that a move along d brings onto it: it is
// bounded by three planes through the edges, with outward normals (edge x d). About n these are the points
// whose foot on the plane lies in the triangle; about the vertical, the column over and under it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/convex_view.h"

namespace epode {

struct Triangle {
    Vec3 v[3];
    Vec3 n;
    Real c = 0;

    Vec3 edge(int k) const { return v[(k + 1) % 3] - v[k]; }
    Real height(Vec3 p) const { return dot(n, p) - c; }  // of p above the plane
};

// False for a triangle without area.
bool make_triangle(Vec3 v0, Vec3 v1, Vec3 v2, Triangle& out);

// The pose is the identity: the view is in the triangle's own frame.
ConvexView view_of(const Triangle& triangle);

// What the triangle shows along a direction: its face (3 corners), edge `at` (2) or corner `at` (1); `top` is
// one of these corners. Heights that differ by less than the sine `level` of the longest edge are the same.
struct Shows {
    int corners;
    int at;
    int top;
};
Real longest_edge(const Triangle& triangle);
inline Shows shown_within(const Triangle& t, Vec3 direction, Real tie)  // a tie is a height
{
    const Real along[3] = {0, dot(direction, t.v[1] - t.v[0]), dot(direction, t.v[2] - t.v[0])};
    const Real largest = std::max(std::max(along[0], along[1]), along[2]), least = largest - tie;
    const unsigned is_top =
        (along[0] >= least ? 1u : 0u) | (along[1] >= least ? 2u : 0u) | (along[2] >= least ? 4u : 0u);
    // Of none, if that can be, to all: of two tops the edge begins at the one after the third corner.
    constexpr std::int8_t kHow[8] = {0, 1, 1, 2, 1, 2, 2, 3}, kAt[8] = {0, 0, 1, 0, 2, 2, 1, 2},
                          kTop[8] = {0, 0, 1, 1, 2, 2, 2, 2};
    return {kHow[is_top], kAt[is_top], kTop[is_top]};
}
inline Shows shown_along(const Triangle& t, Vec3 direction, Real level)
{
    return shown_within(t, direction, level * longest_edge(t));
}

struct Stretch {
    Real from = 0, to = 1;
    bool empty() const { return !(from <= to); }
};

// The part of a..b within the prism about `direction`, widened by `slack`.
Stretch within_prism(const Triangle& triangle, Vec3 direction, Vec3 a, Vec3 b, Real slack);

// Cuts a polygon by the prism about `direction`.
void clip_to_prism(Polygon& polygon, const Triangle& triangle, Vec3 direction, Real slack);

}  // namespace epode
