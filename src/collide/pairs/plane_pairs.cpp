// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box, capsule and cylinder against a plane: the half-space n . x <= d is never passed through, so the
// contacts are simply the lowest points of the solid, each with its own depth d - n . x. Cylinder: the lower
// end's rim carries the contacts. Four rim points at fixed directions of the body are used, and as the
// cylinder tilts, the one nearest to the true lowest point is turned towards it, fully by a tilt of
// kFullTilt; so the points move continuously, and from there on the deepest point is exact. Lying on its
// side, the lowest points of both rims.
#include "collide/pairs/at_once.h"

namespace epode {

namespace {

constexpr Real kFullTilt = Real(1e-3);

struct Below {
    ContactPoint points[8];
    int count = 0;
    void offer(Vec3 p, const Plane& plane)
    {
        const Real depth = plane.d - dot(plane.normal, p);
        if (depth >= 0) points[count++] = {p, plane.normal, depth};
    }
};

// Four rim directions about the axis (unit, local xy), the one nearest to `low` turned towards it by
// `weight`.
void rim_directions(Real low_x, Real low_y, Real weight, Real (&out)[4][2])
{
    constexpr Real kX[4] = {-1, 1, 0, 0}, kY[4] = {0, 0, -1, 1};
    int nearest = 0;
    for (int i = 0; i < 4; ++i) {
        out[i][0] = kX[i], out[i][1] = kY[i];
        if (kX[i] * low_x + kY[i] * low_y > kX[nearest] * low_x + kY[nearest] * low_y) nearest = i;
    }
    const Real x = kX[nearest] + weight * (low_x - kX[nearest]),
               y = kY[nearest] + weight * (low_y - kY[nearest]);
    const Real k = std::sqrt(x * x + y * y);
    out[nearest][0] = x / k, out[nearest][1] = y / k;
}

}  // namespace

void box_plane(const Box& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 n = transposed_times(A.R, b.normal);
    const Real clearance = dot(b.normal, A.p) - b.d;
    const Real reach = dot(abs(n), a.half);
    if (clearance > reach) return;
    ContactPoint lowest[4];  // deepest first, ties by vertex number
    int count = 0;
    const Real tie = 16 * kEpsilon * (reach + std::fabs(clearance));
    for (int i = 0; i < 8; ++i) {
        const Vec3 v = {i & 4 ? -a.half.x : a.half.x, i & 2 ? -a.half.y : a.half.y,
                        i & 1 ? -a.half.z : a.half.z};
        const Real depth = -(clearance + dot(n, v));
        if (!(depth >= 0) || (count == 4 && depth <= lowest[3].depth + tie)) continue;
        int k = count < 4 ? count++ : 3;
        for (; k > 0 && depth > lowest[k - 1].depth + tie; --k) lowest[k] = lowest[k - 1];
        lowest[k] = {A.to_world(v), b.normal, depth};
    }
    for (int i = 0; i < count; ++i) sink.add(lowest[i]);
}

void capsule_plane(const Capsule& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 half = a.half_length * A.R.column(2);
    Below ends;
    ends.offer(A.p - half - a.radius * b.normal, b);
    ends.offer(A.p + half - a.radius * b.normal, b);
    sink.add_manifold({ends.points, std::size_t(ends.count)});
}

void cylinder_plane(const Cylinder& a, const Pose& A, const Plane& b, const Pose&, ContactSink& sink)
{
    const Vec3 n = transposed_times(A.R, b.normal);
    const Real tilt = std::sqrt(n.x * n.x + n.y * n.y);
    const Real end = n.z > 0 ? -a.half_length : a.half_length;
    const Real low_x = tilt > 0 ? -n.x / tilt : Real(-1), low_y = tilt > 0 ? -n.y / tilt : Real(0);
    Below found;
    if (tilt > std::fabs(n.z)) {  // lying
        found.offer(A.to_world({a.radius * low_x, a.radius * low_y, end}), b);
        found.offer(A.to_world({a.radius * low_x, a.radius * low_y, -end}), b);
    } else {
        const Real weight = tilt < kFullTilt ? tilt / kFullTilt : Real(1);
        Real rim[4][2];
        rim_directions(low_x, low_y, weight, rim);
        for (const auto& d : rim) found.offer(A.to_world({a.radius * d[0], a.radius * d[1], end}), b);
    }
    sink.add_manifold({found.points, std::size_t(found.count)});
}

EPODE_AT_ONCE(Box, Plane, box_plane)
EPODE_AT_ONCE(Capsule, Plane, capsule_plane)
EPODE_AT_ONCE(Cylinder, Plane, cylinder_plane)

}  // namespace epode
