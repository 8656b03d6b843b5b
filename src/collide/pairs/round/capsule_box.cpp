// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Capsule against box. Outside: the point of the axis nearest to the box gives normal and depth, exactly.
// With the axis inside the box: the least of the overlaps along the box's faces and along axis x edges
// (separating axes of a segment and a box), plus the radius. When the normal is a face normal, the axis is
// cut by the sides of that face and both ends touch, each with its own depth; likewise along an edge when the
// axis runs along it.
#include "collide/pairs/at_once.h"
#include "geometry/closest.h"

namespace epode {

namespace {

constexpr Real kAligned = Real(1e-3);  // sine between normal and face normal

// Everything in the box's frame.
struct CapsuleInBox {
    Vec3 from, to;  // the axis
    Vec3 half;
    Real radius;
    Vec3 at(Real t) const { return from + t * (to - from); }
};

// Least way to move the segment out of the box.
void way_out(const CapsuleInBox& c, Vec3& normal, Real& depth)
{
    depth = kInf;
    const auto offer = [&](Vec3 n, Real margin) {
        for (const Vec3 m : {n, -n}) {
            const Real x = dot(m, c.from), y = dot(m, c.to);
            const Real h = dot(abs(m), c.half) - (x < y ? x : y);
            if (h + margin < depth) depth = h, normal = m;
        }
    };
    const Real margin = 16 * kEpsilon * max_component(c.half);
    for (int i = 0; i < 3; ++i) {
        Vec3 n;
        n.set(i, 1);
        offer(n, margin);
    }
    for (int i = 0; i < 3; ++i) {
        Vec3 e;
        e.set(i, 1);
        Vec3 n = cross(c.to - c.from, e);
        if (length2(n) > Real(1e-8) * length2(c.to - c.from) && normalize(n)) offer(n, 2 * margin);
    }
}

// The stretch of the axis between the planes of box axis i.
void cut(const CapsuleInBox& c, int i, Real& lo, Real& hi)
{
    const Real o = c.from[i], d = c.to[i] - o;
    if (d == 0) return;
    const Real t1 = (-c.half[i] - o) / d, t2 = (c.half[i] - o) / d;
    lo = std::fmax(lo, std::fmin(t1, t2));
    hi = std::fmin(hi, std::fmax(t1, t2));
}

// The ball at parameter t, against the box moved along `normal`.
bool ball_at(const CapsuleInBox& c, Real t, Vec3 normal, Real depth, const Pose& B, ContactPoint& out)
{
    if (c.radius + depth < 0) return false;
    const Vec3 p = c.at(t), q = clamp_to_box(p, c.half);
    out = {B.to_world(q), B.R * normal, c.radius + depth};
    return true;
}

int aligned_axis(Vec3 n, Real sine)
{
    for (int i = 0; i < 3; ++i) {
        const Real x = n[(i + 1) % 3], y = n[(i + 2) % 3];
        if (x * x + y * y < sine * sine) return i;
    }
    return -1;
}

// How deep the axis point p lies below face `axis`, or below the edge along `axis`, measured along the
// normal.
Real below_face(const CapsuleInBox& c, int axis, Vec3 normal, Vec3 p)
{
    const Real n = normal[axis];
    return (c.half[axis] - (n < 0 ? -p[axis] : p[axis])) / std::fabs(n);
}
Real below_edge(const CapsuleInBox& c, int axis, Vec3 normal, Vec3 p)
{
    Vec3 n = normal;
    n.set(axis, 0);
    return dot(abs(n), c.half) - dot(n, p);
}

// Two points on a face or along an edge; false when there is no stretch, or it misses the deepest point.
bool stretch(const CapsuleInBox& c, Vec3 normal, Real depth, const Pose& B, ContactSink& sink)
{
    const Vec3 d = c.to - c.from;
    const int face = aligned_axis(normal, kAligned);
    const int edge = face < 0 ? aligned_axis(normalized_or(d, {}), Real(1e-2)) : -1;
    if ((face < 0 && edge < 0) || !(length2(d) > 0)) return false;
    Real lo = 0, hi = 1;
    for (int i = 0; i < 3; ++i)
        if (face >= 0 ? i != face : i == edge) cut(c, i, lo, hi);
    if (!(hi - lo > Real(1e-6))) return false;
    ContactPoint points[2];
    int count = 0;
    Real largest = -kInf;
    for (const Real t : {lo, hi}) {
        const Real below =
            face >= 0 ? below_face(c, face, normal, c.at(t)) : below_edge(c, edge, normal, c.at(t));
        const Real at_end = below < depth ? below : depth;
        if (at_end > largest) largest = at_end;
        if (ball_at(c, t, normal, at_end, B, points[count])) ++count;
    }
    if (count == 0 || largest < depth - Real(1e-5) * (max_component(c.half) + length(d))) return false;
    sink.add_manifold({points, std::size_t(count)});
    return true;
}

// Where an axis that pierces the box is deepest along `normal`: nearest to the supporting edge or face.
Real deepest_parameter(const CapsuleInBox& c, Vec3 normal)
{
    const Vec3 d = c.to - c.from;
    Vec3 corner = {normal.x >= 0 ? c.half.x : -c.half.x, normal.y >= 0 ? c.half.y : -c.half.y,
                   normal.z >= 0 ? c.half.z : -c.half.z};
    const Real slope = dot(normal, d);
    if (std::fabs(slope) > Real(1e-9) * length(d)) return slope > 0 ? Real(0) : Real(1);
    Vec3 other = corner, p, q;  // the edge that the normal is perpendicular to
    for (int i = 0; i < 3; ++i)
        if (std::fabs(normal[i]) < Real(1e-9)) other.set(i, -corner[i]);
    closest_segment_points(c.from, c.to, corner, other, p, q);
    return closest_on_segment(c.from, c.to, p);
}

}  // namespace

void capsule_box(const Capsule& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    const Vec3 reach = a.half_length * A.R.column(2);
    const CapsuleInBox c = {B.to_local(A.p - reach), B.to_local(A.p + reach), b.half, a.radius};
    Real t = closest_to_box(c.from, c.to, c.half);
    const Vec3 p = c.at(t);
    Vec3 n = p - clamp_to_box(p, c.half);
    const Real distance = length(n);
    if (distance > a.radius) return;
    Real depth = -distance;
    const Real noise = 16 * kEpsilon * (max_component(b.half) + max_component(abs(p)));
    if (!(distance > noise) || !normalize(n)) {
        way_out(c, n, depth);
        t = deepest_parameter(c, n);
    }
    if (stretch(c, n, depth, B, sink)) return;
    ContactPoint point;
    if (ball_at(c, t, n, depth, B, point)) sink.add(point);
}

EPODE_AT_ONCE(Capsule, Box, capsule_box)

}  // namespace epode
