// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two boxes or polyhedra: see flat_overlap.h. All is computed in a's frame, of b only what is needed there.
// The arcs of the edges p (between faces of a, turned round) and q (of b) cross when the normals of q's faces
// lie on either side of p's plane, those of p's on either side of q's, and the crossing is on the same half
// of the sphere: with l, r the normals to the left and right,
//   (lq.p)(rq.p) < 0,   (lp.q)(rp.q) < 0,   (lq.p)(rp.q) < 0,   and then n has the sense of -(lq.p) p x q.
// Where so many edges are near that the products would cost more, the polytope of epa.h goes on from there.
#include "geometry/overlap/flat_overlap.h"

#include <algorithm>

namespace epode {

namespace {

constexpr int kNearEdges = 64;  // near, of either solid
constexpr int kProducts = 1200;

// An edge in a's frame with its faces' normals.
struct Placed {
    Vec3 at, along, left, right;
};

struct NearEdges {
    union {
        Placed edges[kNearEdges];  // left unwritten until used
    };
    int count = 0;
    bool all = true;  // there was room
    NearEdges() {}
};

// Edges of s that may take part in an overlap of less than `depth`. `inward`: away from the other solid,
// which ends at height `limit` along it or nearer.
struct Nearness {
    Vec3 other_inner;
    Real other_radius;
    Vec3 inward;
    Real limit;
    Real depth;
};

void gather(const FlatSolid& s, const Nearness& near, const Pose& place, NearEdges& out)
{
    const FaceGaps gap(s, near.other_inner);
    const Real bound = near.other_radius - near.depth;
    for (const PolyhedronEdge& e : s.edges) {
        const Real widest = std::max(gap[std::size_t(e.left)], gap[std::size_t(e.right)]);
        if (widest < (bound > 0 ? bound * e.cos_half : bound)) continue;
        const Vec3 p = s.vertices[std::size_t(e.from)], q = s.vertices[std::size_t(e.to)];
        if (std::min(dot(near.inward, p), dot(near.inward, q)) > near.limit) continue;
        if (out.count == kNearEdges) {
            out.all = false;
            return;
        }
        out.edges[out.count++] = {place.to_world(p), place.R * (q - p),
                                  place.R * s.faces[std::size_t(e.left)].normal,
                                  place.R * s.faces[std::size_t(e.right)].normal};
    }
}

// The least overlap along products of the edges, `normal` being from b to a.
void try_products(const NearEdges& of_a, const NearEdges& of_b, Real handicap, Real& depth, Vec3& normal)
{
    for (int j = 0; j < of_b.count; ++j) {
        const Placed& q = of_b.edges[j];
        for (int i = 0; i < of_a.count; ++i) {
            const Placed& p = of_a.edges[i];
            const Real lq = dot(q.left, p.along), rq = dot(q.right, p.along);
            if (!(lq * rq < 0)) continue;
            const Real lp = dot(p.left, q.along), rp = dot(p.right, q.along);
            if (!(lp * rp < 0) || !(lq * rp < 0)) continue;
            const Vec3 n = lq < 0 ? cross(p.along, q.along) : cross(q.along, p.along);
            const Real n2 = length2(n);
            if (n2 < Real(1e-6) * length2(p.along) * length2(q.along)) continue;
            const Real scaled = dot(n, q.at - p.at), goal = depth - handicap;
            if (scaled > 0 && (goal <= 0 || scaled * scaled >= goal * goal * n2)) continue;
            const Real size = std::sqrt(n2), h = scaled / size;
            if (h < goal) depth = h, normal = n / size;
        }
    }
}

}  // namespace

FlatPair::FlatPair(const ConvexView& a, const ConvexView& b)
    : a_(a),
      b_(b),
      flat_a_(a),
      flat_b_(b),
      b_in_a_(inverse_times(a.pose, b.pose)),
      handicap_(kPreference * (a.size + b.size))
{
    a_in_b_.R = transpose(b_in_a_.R);
    a_in_b_.p = -(a_in_b_.R * b_in_a_.p);
}

void FlatPair::try_faces_of(const FlatSolid& s, const FlatSolid& other, const Pose& place, bool first,
                            Real enough)
{
    const Vec3 inner = place.to_world(other.inner);
    const FaceGaps gap(s, inner);
    const Real handicap = first ? Real(0) : handicap_;
    const auto offer = [&](const PolyhedronFace& f) {
        const Vec3 d = -transposed_times(place.R, f.normal), v = other.support(d);
        const Real h = f.offset - dot(f.normal, place.p) + dot(d, v);
        if (!(h + handicap < best.depth)) return;
        best.depth = h, deepest_ = v, of_first_ = first;
        normal_ = f.normal;
    };
    offer(s.faces[gap.widest]);
    gap.each_that_may_be_less(other.inner_radius, handicap_, best.depth, [&](const PolyhedronFace& f, Real) {
        if (best.depth >= enough) offer(f);
    });
}

void FlatPair::try_faces(Real enough)
{
    try_faces_of(flat_a_, flat_b_, b_in_a_, true, enough);
    if (best.depth >= enough) try_faces_of(flat_b_, flat_a_, a_in_b_, false, enough);
    best.normal = of_first_ ? -(a_.pose.R * normal_) : b_.pose.R * normal_;
    if (of_first_)
        deepest_ = b_in_a_.to_world(deepest_), normal_ = -normal_;
    else
        deepest_ = a_in_b_.to_world(deepest_), normal_ = b_in_a_.R * normal_;
}

bool FlatPair::proven() const
{
    const Real enough = best.depth - 2 * handicap_;
    return (of_first_ ? flat_a_ : flat_b_).within(deepest_, enough) >= enough;
}

bool FlatPair::proven_at(Vec3 point) const
{
    const Real enough = best.depth - 2 * handicap_;
    const FlatSolid &reference = of_first_ ? flat_a_ : flat_b_, &other = of_first_ ? flat_b_ : flat_a_;
    const Pose &place = of_first_ ? a_.pose : b_.pose, &other_place = of_first_ ? b_.pose : a_.pose;
    const Real within = reference.within(place.to_local(point), 0);
    return within > 0 && within + other.within(other_place.to_local(point), enough - within) >= enough;
}

void FlatPair::try_rest(Real enough)
{
    const Real depth = best.depth > 0 ? best.depth : Real(0);
    const Vec3 in_b = transposed_times(b_in_a_.R, -normal_);
    const Real low_a = dot(normal_, flat_a_.support(-normal_)), low_b = dot(in_b, flat_b_.support(-in_b));
    const Real hair = 16 * handicap_;
    NearEdges of_a, of_b;
    gather(flat_a_,
           {b_in_a_.to_world(flat_b_.inner), flat_b_.inner_radius, normal_, low_a + 2 * depth + hair, depth},
           Pose{}, of_a);
    gather(flat_b_,
           {a_in_b_.to_world(flat_a_.inner), flat_a_.inner_radius, in_b, low_b + 2 * depth + hair, depth},
           b_in_a_, of_b);
    if (of_a.all && of_b.all && of_a.count * of_b.count <= kProducts) {
        Vec3 n = normal_;
        Real least = best.depth;
        try_products(of_a, of_b, 2 * handicap_, least, n);
        if (least < best.depth) best.depth = least, best.normal = a_.pose.R * n;
        return;
    }
    Overlap grown = best;
    expand(a_, b_, 16 * kEpsilon * (a_.size + b_.size), enough, grown);
    if (grown.depth + 2 * handicap_ < best.depth) best = grown;
}

}  // namespace epode
