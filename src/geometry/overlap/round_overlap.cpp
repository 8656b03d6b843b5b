// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A box or polyhedron and a round core: see flat_overlap.h. The edges are looked at in the core's frame, its
// axis being z (overlap_arc.h): n turns about an edge from the normal of one of its faces to the other's, m
// being halfway.
#include "geometry/overlap/flat_overlap.h"
#include "geometry/overlap/overlap_arc.h"

namespace epode {

namespace {

constexpr Real kWidest = Real(1e4);  // tangent: half of an arc of 180 degrees

// Half the arc as an angle's tangent, and its middle; an edge of a plate has opposite normals.
Real middle_of(Vec3 along, Vec3 left, Vec3 right, Vec3& m)
{
    m = left + right;
    const Real wide = length(left - right), sum = length(m);
    if (wide < kWidest * sum && normalize(m)) return wide / sum;
    m = cross(along, left);
    return kWidest;
}

// A bound below the overlap along all normals between two: with s the core's farthest point along one of
// them, n . (at + s), which is least at an end where it is positive at both. Less where it is not.
Real least_over_arc(const RoundCore& core, Vec3 at, Vec3 left, Vec3 right)
{
    const Vec3 point = at + core.support(left + right);
    const Real one = dot(left, point), other = dot(right, point);
    const Real least = one < other ? one : other;
    return least > 0 ? least : -kInf;
}

}  // namespace

RoundPair::RoundPair(const ConvexView& a, const ConvexView& b)
    : flat_view_(FlatSolid::is_flat(a) ? a : b),
      round_view_(FlatSolid::is_flat(a) ? b : a),
      sense_(FlatSolid::is_flat(a) ? Real(-1) : Real(1)),
      flat_(flat_view_),
      round_(round_view_),
      round_in_flat_(inverse_times(flat_view_.pose, round_view_.pose)),
      gap_(flat_, round_in_flat_.p),
      handicap_(kPreference * (a.size + b.size))
{}

void RoundPair::offer(Vec3 outward, Real depth, Real handicap)
{
    if (depth + handicap < best.depth) best.depth = depth, outward_ = outward;
}

// The end that looks back along `outward`.
void RoundPair::try_end(Vec3 outward)
{
    const Vec3 v = flat_.support(outward);
    offer(outward, dot(outward, v - round_in_flat_.p) + round_.half_length, handicap_);
}

void RoundPair::try_faces(Real enough)
{
    const Vec3 c = round_in_flat_.p, axis = round_in_flat_.R.column(2);
    const auto offer_face = [&](const PolyhedronFace& f, Real g) {
        offer(f.normal, round_.reach(transposed_times(round_in_flat_.R, f.normal)) - g, 0);
    };
    offer_face(flat_.faces[gap_.widest], gap_[gap_.widest]);
    gap_.each_that_may_be_less(round_.inner_radius, handicap_, best.depth,
                               [&](const PolyhedronFace& f, Real g) {
                                   if (best.depth >= enough) offer_face(f, g);
                               });
    if (round_.radius > 0 && best.depth >= enough) {
        const Real along = dot(axis, c - flat_.inner);
        const Vec3 out = along < 0 ? -axis : axis;
        try_end(out);
        if (flat_.inner_radius + std::fabs(along) + round_.half_length < best.depth) try_end(-out);
    }
    best.normal = sense_ * (flat_view_.pose.R * outward_);
}

bool RoundPair::proven() const
{
    const Real enough = best.depth - 2 * handicap_;
    Vec3 d = -transposed_times(round_in_flat_.R, outward_);
    if (round_.half_length * std::fabs(d.z) <= handicap_) {  // it lies: the middle of the line
        const Real rho = std::sqrt(d.x * d.x + d.y * d.y), k = rho > 0 ? round_.radius / rho : Real(0);
        return flat_.within(round_in_flat_.to_world({k * d.x, k * d.y, 0}), enough) >= enough;
    }
    if (round_.radius * std::sqrt(d.x * d.x + d.y * d.y) <= handicap_) d.x = d.y = 0;  // it stands
    return flat_.within(round_in_flat_.to_world(round_.support(d)), enough) >= enough;
}

bool RoundPair::proven_at(Vec3 point) const
{
    const Real enough = best.depth - 2 * handicap_;
    const Real within = round_.within(round_view_.pose.to_local(point), 0);
    return flat_.within(flat_view_.pose.to_local(point), enough - within) + within >= enough;
}

Vec3 RoundPair::nearest_to_axis() const
{
    const Vec3 axis = round_in_flat_.R.column(2);
    Vec3 nearest;
    Real least = kInf;
    for (const Vec3 v : flat_.vertices) {
        const Vec3 d = v - round_in_flat_.p;
        const Real along = dot(axis, d), rho2 = length2(d) - along * along;
        if (rho2 < least) least = rho2, nearest = v;
    }
    return nearest;
}

void RoundPair::try_rest(Real enough)
{
    if (!(round_.half_length > 0) && !(round_.radius > 0)) return;  // a point meets faces only
    const Mat3 turn = transpose(round_in_flat_.R);
    const Vec3 c = round_in_flat_.p;
    const Real hair = 16 * handicap_;
    const Real limit = -round_.reach(turn * outward_) - (best.depth > 0 ? best.depth : 0) - hair;
    Vec3 found;
    bool better = false;
    const auto offer_local = [&](Vec3 n, Real h) {
        if (!(h + 2 * handicap_ < best.depth) || !normalize(n)) return;
        best.depth = h, found = n, better = true;
    };
    const auto high = [&](int vertex) { return dot(outward_, flat_.vertices[std::size_t(vertex)] - c); };
    for (const PolyhedronEdge& e : flat_.edges) {
        if (best.depth < enough) break;
        const Real one = gap_[std::size_t(e.left)], other = gap_[std::size_t(e.right)];
        const Real bound = round_.inner_radius - best.depth;
        if ((one > other ? one : other) < (bound > 0 ? bound * e.cos_half : bound)) continue;
        if (high(e.from) < limit && high(e.to) < limit) continue;
        const Vec3 p = turn * (flat_.vertices[std::size_t(e.from)] - c),
                   q = turn * (flat_.vertices[std::size_t(e.to)] - c);
        Vec3 along = q - p, m;
        const Vec3 left = turn * flat_.faces[std::size_t(e.left)].normal,
                   right = turn * flat_.faces[std::size_t(e.right)].normal;
        if (least_over_arc(round_, p, left, right) + handicap_ >= best.depth || !normalize(along)) continue;
        const Real half = middle_of(along, left, right, m);
        try_arc({p, m, cross(along, m), round_.radius, round_.half_length}, half, offer_local);
    }
    if (round_.radius > 0) {  // the corner nearest to the axis, if no other point is nearer
        const Vec3 nearest = turn * (nearest_to_axis() - c);
        const Real rho = std::sqrt(nearest.x * nearest.x + nearest.y * nearest.y);
        if (rho > 0 && round_.radius - rho + 2 * handicap_ < best.depth) {
            const Vec3 n = {-nearest.x / rho, -nearest.y / rho, 0};
            const Vec3 top = flat_.support(round_in_flat_.R * n);
            offer_local(n, dot(n, turn * (top - c)) + round_.radius);
        }
    }
    if (better) best.normal = sense_ * (round_view_.pose.R * found);
}

}  // namespace epode
